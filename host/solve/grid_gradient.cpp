#include "solve/grid_gradient.h"

#include <fmt/format.h>

#include "core/error.h"
#include "shared/hessian_types.h"
#include "solve/gradient_comp.h"
#include "solve/gradient_precise_comp.h"
#include "solve/gradient_sums_comp.h"

namespace morphgrid {
namespace {

ShaderCode spirvOf(const Device& device, Precision precision) {
  if (precision == Precision::single) {
    return gradient_comp_spirv;
  }
  if (!device.hasFloat64()) {
    throw DeviceError(fmt::format("device {} cannot compute in double precision", device.name()));
  }
  return gradient_precise_comp_spirv;
}

}  // namespace

GridGradient::GridGradient(const Device& device, const DeviceGrid& grid, Precision precision,
                           LayerLoop loop)
    : device_(device),
      walk_(device, grid, precision == Precision::single ? kSweepBlockV : kPreciseSweepBlockV,
            loop),
      texels_(device, grid),
      partials_(device, walk_.groupCount() * sizeof(vec4), BufferUsage::storageBuffer,
                MemoryKind::device),
      sums_(device, sizeof(vec4), BufferUsage::storageBuffer, MemoryKind::host),
      kernels_(device, spirvOf(device, precision), sizeof(GridPush), walk_.constants()),
      reduction_(device, gradient_sums_comp_spirv,
                 {{kBindingPartials, &partials_}, {kBindingSums, &sums_}}, sizeof(ReductionPush)) {}

GridGradient::Evaluation GridGradient::evaluation(const Buffer& positions,
                                                  const VertexVector& gradient) {
  TexelView view = integerTexels(device_, positions);
  ComputeKernel kernel = kernels_.bind({{kBindingPositions, &view},
                                        {kBindingRest, &texels_.rest},
                                        {kBindingStiffness, &texels_.stiffness},
                                        {kBindingResult, &gradient.buffer()},
                                        {kBindingPartials, &partials_}});
  return {std::move(view), std::move(kernel)};
}

void GridGradient::record(CommandStream& stream, const Evaluation& evaluation) const {
  stream.dispatch(evaluation.kernel_, walk_.push(), walk_.groupsU(), walk_.groupsV());
  stream.dispatch(reduction_, ReductionPush{walk_.groupCount()}, 1);
}

GridGradient::Sums GridGradient::sums() const {
  const vec4 pairs = sums_.mapped<vec4>()[0];
  return {double(pairs.x) + double(pairs.y), double(pairs.z) + double(pairs.w)};
}

}  // namespace morphgrid
