#include "solve/adjoint_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shared/adjoint_types.h"
#include "solve/adjoint_advance_comp.h"
#include "solve/adjoint_direction_comp.h"
#include "solve/adjoint_dots_comp.h"
#include "solve/adjoint_scalars_comp.h"

namespace morphgrid {

using Eigen::Matrix3Xd;

AdjointSolver::AdjointSolver(const Device& device, PreconditionedDescent& descent)
    : device_(device),
      descent_(descent),
      count_(static_cast<std::uint32_t>(descent.vectorLength())),
      remainder_(descent.rightSide()),
      correction_(descent.correction()),
      direction_(descent.direction()),
      solution_(device, descent.vectorLength()),
      product_(device, descent.vectorLength()),
      sums_(device, reductionGroups(count_) * sizeof(vec2), BufferUsage::storageBuffer,
            MemoryKind::device),
      scalars_(device, sizeof(ConjugateScalars),
               BufferUsage::storageBuffer | BufferUsage::transferDst, MemoryKind::host),
      multiplication_(descent.cycle().hessian().exactProduct(direction_, product_)),
      directionDots_(dots(direction_, product_)),
      remainderDots_(dots(remainder_, correction_)),
      advance_(device, adjoint_advance_comp_spirv,
               {{kBindingFirst, &direction_.texels()},
                {kBindingSecond, &product_.texels()},
                {kBindingSolution, &solution_.buffer()},
                {kBindingRemainder, &remainder_.buffer()},
                {kBindingScalars, &scalars_}},
               sizeof(AdvancePush)),
      turn_(device, adjoint_direction_comp_spirv,
            {{kBindingFirst, &correction_.texels()},
             {kBindingSolution, &direction_.buffer()},
             {kBindingScalars, &scalars_}},
            sizeof(AdvancePush)),
      updateScalars_(device, adjoint_scalars_comp_spirv,
                     {{kBindingProducts, &sums_}, {kBindingScalars, &scalars_}},
                     sizeof(ScalarsPush)),
      stream_(device) {}

ComputeKernel AdjointSolver::dots(const VertexVector& first, const VertexVector& second) {
  return {device_,
          adjoint_dots_comp_spirv,
          {{kBindingFirst, &first.texels()},
           {kBindingSecond, &second.texels()},
           {kBindingProducts, &sums_}},
          sizeof(DotsPush)};
}

void AdjointSolver::recordScalars(const ComputeKernel& dots, std::uint32_t stage) {
  const std::uint32_t groups = reductionGroups(count_);
  stream_.dispatch(dots, DotsPush{count_, groups * kVectorInvocations}, groups);
  stream_.dispatch(updateScalars_, ScalarsPush{groups, stage}, 1);
}

void AdjointSolver::recordCycle() {
  descent_.cycle().record(stream_);
  recordScalars(remainderDots_, kScalarsOfRemainder);
}

void AdjointSolver::recordStart() {
  for (const VertexVector* vector :
       {&std::as_const(solution_), &direction_, &std::as_const(product_)}) {
    stream_.clear(vector->buffer());
  }
  stream_.clear(scalars_);
  recordCycle();
}

void AdjointSolver::recordStep() {
  const std::uint32_t groups = groupsFor(static_cast<int>(count_), kVectorInvocations);
  stream_.dispatch(turn_, AdvancePush{count_}, groups);
  descent_.cycle().hessian().record(stream_, multiplication_);
  recordScalars(directionDots_, kScalarsOfProduct);
  stream_.dispatch(advance_, AdvancePush{count_}, groups);
  recordCycle();
}

Adjoint AdjointSolver::solve(const Matrix3Xd& rightSide, const AdjointOptions& options) {
  Adjoint result;
  result.lambda = Matrix3Xd::Zero(3, rightSide.cols());
  const double scale = rightSide.cwiseAbs().maxCoeff();
  if (scale == 0) {
    result.converged = true;
    return result;
  }
  descent_.takeHessian();
  remainder_.upload(device_, rightSide / scale);
  const double norm = rightSide.norm() / scale;
  const ConjugateScalars& scalars = scalars_.mapped<ConjugateScalars>().front();
  result.residual = 1;
  // On a small grid waiting for the device is a good part of the time: as many products as the last
  // solve took, but for one, go in one submission.
  int batch = std::max(1, usualProducts_ - 1);
  while (result.products < options.productLimit && result.residual > options.tolerance) {
    stream_.begin();
    if (result.products == 0) {
      recordStart();
    }
    batch = std::min(batch, options.productLimit - result.products);
    for (int n = 0; n < batch; ++n) {
      recordStep();
    }
    stream_.end();
    stream_.submitAndWait();
    if (scalars.isNotPositive != 0) {
      break;
    }
    result.products += batch;
    result.residual = std::sqrt(scalars.squared) / norm;
    batch = 1;
  }
  result.converged = result.residual <= options.tolerance;
  usualProducts_ = std::max(1, result.products);
  result.lambda = scale * solution_.download(device_);
  return result;
}

}  // namespace morphgrid
