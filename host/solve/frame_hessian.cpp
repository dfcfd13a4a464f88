#include "solve/frame_hessian.h"

#include "solve/column_walk.h"
#include "solve/frame_blocks_comp.h"
#include "solve/frame_exact_product_comp.h"
#include "solve/frame_first_smoothing_comp.h"
#include "solve/frame_product_comp.h"
#include "solve/frame_residual_comp.h"
#include "solve/frame_smoothing_comp.h"

namespace morphgrid {
namespace {

/// A bar has two ends, so no eigenvalue of D^-1 H is above 2: damps from an eighth of that on.
constexpr double kSmoothingWeight = 2 / (2 * (1 + 1.0 / 8));

}  // namespace

FrameHessian::FrameHessian(const Device& device, const DeviceGrid& grid)
    : Hessian(device, grid, kSmoothingWeight),
      device_(device),
      shape_(grid.shape()),
      columns_(device, grid),
      inverse_(device, shape_.vertexCount(), MemoryKind::device),
      products_(family(frame_product_comp_spirv)),
      exactProducts_(family(frame_exact_product_comp_spirv)),
      residuals_(family(frame_residual_comp_spirv)),
      smoothings_(device, frame_smoothing_comp_spirv, sizeof(FramePush), {}),
      firstSmoothings_(device, frame_first_smoothing_comp_spirv, sizeof(FramePush), {}),
      blocks_(device, frame_blocks_comp_spirv, blockResources(), sizeof(FramePush),
              columns_.constants()) {}

KernelFamily FrameHessian::family(ShaderCode spirv) const {
  return {device_, spirv, sizeof(FramePush), columns_.constants()};
}

std::vector<KernelResource> FrameHessian::blockResources() const {
  std::vector<KernelResource> resources{{kBindingPositions, &positionsView()}};
  columns_.appendResources(resources);
  inverse_.appendBuffers(resources, kBindingInverse);
  return resources;
}

Hessian::Step FrameHessian::columnStep(KernelFamily& kernels, const VertexVector& z,
                                       const VertexVector& result,
                                       std::vector<KernelResource> others) {
  others.insert(others.end(), {{kBindingPositions, &positionsView()},
                               {kBindingVector, &z.texels()},
                               {kBindingResult, &result.buffer()}});
  columns_.appendResources(others);
  return {kernels.bind(others), Step::Dispatch::columns};
}

Hessian::Step FrameHessian::vertexStep(KernelFamily& kernels, const VertexVector& result,
                                       std::vector<KernelResource> others) {
  others.push_back({kBindingResult, &result.buffer()});
  inverse_.appendTexels(others, kBindingInverse);
  return {kernels.bind(others), Step::Dispatch::vertices};
}

Hessian::Step FrameHessian::product(const VertexVector& z, const VertexVector& y) {
  return columnStep(products_, z, y, {});
}

Hessian::Step FrameHessian::exactProduct(const VertexVector& z, const VertexVector& y) {
  return columnStep(exactProducts_, z, y, {});
}

Hessian::Step FrameHessian::residual(const VertexVector& z, const VertexVector& b,
                                     const VertexVector& r) {
  return columnStep(residuals_, z, r, {{kBindingRightSide, &b.texels()}});
}

Hessian::Step FrameHessian::smoothing(const VertexVector& z, const VertexVector& r,
                                      const VertexVector& next) {
  return vertexStep(smoothings_, next,
                    {{kBindingVector, &z.texels()}, {kBindingRightSide, &r.texels()}});
}

Hessian::Step FrameHessian::firstSmoothing(const VertexVector& b, const VertexVector& z) {
  return vertexStep(firstSmoothings_, z, {{kBindingRightSide, &b.texels()}});
}

FramePush FrameHessian::push() const {
  FramePush push = columns_.push();
  push.damping = damping();
  push.weight = smoothingWeight();
  return push;
}

void FrameHessian::recordLinearisation(CommandStream& stream, const Buffer& positions) const {
  stream.copy(positions, this->positions(), positions.bytes());
  stream.dispatch(blocks_, push(), columns_.groupsU(), columns_.groupsV(),
                  static_cast<std::uint32_t>(shape_.layers));
}

void FrameHessian::record(CommandStream& stream, const Step& step) const {
  if (step.dispatch == Step::Dispatch::columns) {
    stream.dispatch(step.kernel, push(), columns_.groupsU(), columns_.groupsV());
  } else {
    stream.dispatch(step.kernel, push(), groupsFor(shape_.layerVertexCount(), kVertexInvocations),
                    static_cast<std::uint32_t>(shape_.layers));
  }
}

}  // namespace morphgrid
