#include "solve/column_walk.h"

namespace morphgrid {
namespace {

/// Up to here, compiling the unrolled loops takes longer than they save in a multigrid solve.
constexpr int kFewVertices = 20000;

}  // namespace

LayerLoop layerLoopFor(const GridShape& shape) {
  return shape.vertexCount() <= kFewVertices ? LayerLoop::rolled : LayerLoop::unrolled;
}

std::uint32_t groupsFor(int count, std::uint32_t groupSize) {
  return (static_cast<std::uint32_t>(count) + groupSize - 1) / groupSize;
}

GridPush gridPushOf(const DeviceGrid& grid) {
  const auto stiffness = grid.uniformStiffness().value_or(UniformStiffness{});
  const auto& [angle, postAngle] = grid.weights();  // Names all of them, or does not compile.
  return {.size = sizeOf(grid.shape()),
          .resolution = static_cast<float>(grid.resolution()),
          .restResolution = static_cast<float>(grid.restResolution()),
          .angleWeight = static_cast<float>(angle),
          .postAngleWeight = static_cast<float>(postAngle),
          .lateralStiffness = stiffness.lateral,
          .verticalStiffness = stiffness.vertical};
}

ColumnWalk::ColumnWalk(const Device& device, const DeviceGrid& grid, std::uint32_t blockV,
                       LayerLoop loop)
    : grid_(grid),
      loop_(loop),
      subgroupSize_(device.subgroupSize()),
      groupsU_(groupsFor(grid.shape().verticesU, kSweepBlockU * subgroupSize_)),
      groupsV_(groupsFor(grid.shape().verticesV, blockV)) {}

std::vector<std::uint32_t> ColumnWalk::constants(bool measures) const {
  const auto layers = static_cast<std::uint32_t>(grid_.shape().layers);
  const bool unrolled = loop_ == LayerLoop::unrolled && layers <= kUnrolledLayers;
  std::vector<std::uint32_t> constants(kColumnConstants);
  constants[kConstantSubgroupSize] = subgroupSize_;
  constants[kConstantLayers] = unrolled ? layers : 0;
  constants[kConstantUniformStiffness] = grid_.uniformStiffness() ? 1 : 0;
  constants[kConstantMeasures] = measures ? 1 : 0;
  constants[kConstantPrintedCorners] = grid_.mechanics() == Mechanics::springsAsPrinted ? 1 : 0;
  return constants;
}

TexelView integerTexels(const Device& device, const Buffer& buffer) {
  return {device, buffer, TexelFormat::int4, TexelAccess::image};
}

TexelView floatTexels(const Device& device, const Buffer& buffer) {
  return {device, buffer, TexelFormat::float4, TexelAccess::image};
}

GridTexels::GridTexels(const Device& device, const DeviceGrid& grid)
    : rest_(integerTexels(device, grid.rest())),
      stiffness_(floatTexels(device, grid.stiffness())),
      printed_(floatTexels(device, grid.printed())) {}

void GridTexels::appendTo(std::vector<KernelResource>& resources) const {
  resources.insert(
      resources.end(),
      {{kBindingRest, &rest_}, {kBindingStiffness, &stiffness_}, {kBindingPrinted, &printed_}});
}

}  // namespace morphgrid
