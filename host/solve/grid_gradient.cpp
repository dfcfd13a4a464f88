#include "solve/grid_gradient.h"

#include <fmt/format.h>

#include "core/error.h"
#include "shared/hessian_types.h"
#include "solve/frame_gradient_comp.h"
#include "solve/frame_gradient_precise_comp.h"
#include "solve/gradient_comp.h"
#include "solve/gradient_precise_comp.h"
#include "solve/gradient_sums_comp.h"

namespace morphgrid {
namespace {

ShaderCode spirvOf(const Device& device, const DeviceGrid& grid, Precision precision) {
  if (precision == Precision::single) {
    return grid.isFrame() ? frame_gradient_comp_spirv : gradient_comp_spirv;
  }
  if (!device.hasFloat64()) {
    throw DeviceError(fmt::format("device {} cannot compute in double precision", device.name()));
  }
  return grid.isFrame() ? frame_gradient_precise_comp_spirv : gradient_precise_comp_spirv;
}

}  // namespace

GridGradient::GridGradient(const Device& device, const DeviceGrid& grid, Precision precision,
                           LayerLoop loop)
    : device_(device),
      walk_(device, grid, precision == Precision::single ? kSweepBlockV : kPreciseSweepBlockV,
            loop),
      texels_(device, grid),
      frame_(grid.isFrame() ? std::optional<FrameColumns>(std::in_place, device, grid)
                            : std::nullopt),
      partials_(device, groupCount() * sizeof(vec4), BufferUsage::storageBuffer,
                MemoryKind::device),
      sums_(device, sizeof(vec4), BufferUsage::storageBuffer, MemoryKind::host),
      kernels_(device, spirvOf(device, grid, precision),
               frame_ ? sizeof(FramePush) : sizeof(GridPush),
               frame_ ? frame_->constants() : walk_.constants()),
      reduction_(device, gradient_sums_comp_spirv,
                 {{kBindingPartials, &partials_}, {kBindingSums, &sums_}}, sizeof(ReductionPush)) {}

std::uint32_t GridGradient::groupCount() const {
  return frame_ ? frame_->groupCount() : walk_.groupCount();
}

GridGradient::Evaluation GridGradient::evaluation(const Buffer& positions,
                                                  const VertexVector& gradient) {
  TexelView view = integerTexels(device_, positions);
  std::vector<KernelResource> resources{{kBindingPositions, &view},
                                        {kBindingResult, &gradient.buffer()},
                                        {kBindingPartials, &partials_}};
  if (frame_) {
    frame_->appendResources(resources);
  } else {
    texels_.appendTo(resources);
  }
  ComputeKernel kernel = kernels_.bind(resources);
  return {std::move(view), std::move(kernel)};
}

void GridGradient::record(CommandStream& stream, const Evaluation& evaluation) const {
  if (frame_) {
    stream.dispatch(evaluation.kernel_, frame_->push(), frame_->groupsU(), frame_->groupsV());
  } else {
    stream.dispatch(evaluation.kernel_, walk_.push(), walk_.groupsU(), walk_.groupsV());
  }
  stream.dispatch(reduction_, ReductionPush{groupCount()}, 1);
}

GridGradient::Sums GridGradient::sums() const {
  const vec4 pairs = sums_.mapped<vec4>()[0];
  return {double(pairs.x) + double(pairs.y), double(pairs.z) + double(pairs.w)};
}

}  // namespace morphgrid
