#include "solve/column_walk.h"

namespace morphgrid {
namespace {

std::uint32_t groupsFor(int count, std::uint32_t groupSize) {
  return (static_cast<std::uint32_t>(count) + groupSize - 1) / groupSize;
}

}  // namespace

ColumnWalk::ColumnWalk(const Device& device, const DeviceGrid& grid, std::uint32_t blockV)
    : grid_(grid),
      subgroupSize_(device.subgroupSize()),
      groupsU_(groupsFor(grid.shape().verticesU, kSweepBlockU * subgroupSize_)),
      groupsV_(groupsFor(grid.shape().verticesV, blockV)) {}

std::vector<std::uint32_t> ColumnWalk::constants(const std::vector<std::uint32_t>& own) const {
  const auto layers = static_cast<std::uint32_t>(grid_.shape().layers);
  const std::uint32_t unrolledLayers = layers <= kUnrolledLayers ? layers : 0;
  const std::uint32_t uniform = grid_.uniformStiffness() ? 1 : 0;
  std::vector<std::uint32_t> all{subgroupSize_, unrolledLayers, uniform};
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

GridPush ColumnWalk::push() const {
  const GridShape& shape = grid_.shape();
  const auto stiffness = grid_.uniformStiffness().value_or(UniformStiffness{});
  return {shape.verticesU,
          shape.verticesV,
          shape.layers,
          static_cast<float>(grid_.resolution()),
          static_cast<float>(grid_.restResolution()),
          static_cast<float>(grid_.angleWeight()),
          stiffness.lateral,
          stiffness.vertical};
}

TexelView integerTexels(const Device& device, const Buffer& buffer) {
  return {device, buffer, vk::Format::eR32G32B32A32Sint, sizeof(ivec4), TexelAccess::image};
}

TexelView floatTexels(const Device& device, const Buffer& buffer) {
  return {device, buffer, vk::Format::eR32G32B32A32Sfloat, sizeof(vec4), TexelAccess::image};
}

GridTexels::GridTexels(const Device& device, const DeviceGrid& grid)
    : rest(integerTexels(device, grid.rest())), stiffness(floatTexels(device, grid.stiffness())) {}

}  // namespace morphgrid
