#include "solve/adjoint_solver.h"

#include <cmath>

#include "shared/adjoint_types.h"
#include "solve/adjoint_advance_comp.h"
#include "solve/adjoint_direction_comp.h"
#include "solve/adjoint_dots_comp.h"

namespace morphgrid {

using Eigen::Matrix3Xd;

AdjointSolver::AdjointSolver(const Device& device, PreconditionedDescent& descent)
    : device_(device),
      descent_(descent),
      count_(static_cast<std::uint32_t>(descent.shape().vertexCount())),
      remainder_(descent.rightSide()),
      correction_(descent.correction()),
      direction_(descent.direction()),
      solution_(device, descent.shape().vertexCount()),
      product_(device, descent.shape().vertexCount()),
      sums_(device, reductionGroups(count_) * sizeof(vec2), BufferUsage::storageBuffer,
            MemoryKind::host),
      multiplication_(descent.cycle().hessian().exactProduct(direction_, product_)),
      directionDots_(dots(direction_, product_)),
      remainderDots_(dots(remainder_, correction_)),
      advance_(device, adjoint_advance_comp_spirv,
               {{kBindingFirst, &direction_.texels()},
                {kBindingSecond, &product_.texels()},
                {kBindingSolution, &solution_.buffer()},
                {kBindingRemainder, &remainder_.buffer()}},
               sizeof(AdvancePush)),
      turn_(device, adjoint_direction_comp_spirv,
            {{kBindingFirst, &correction_.texels()}, {kBindingSolution, &direction_.buffer()}},
            sizeof(AdvancePush)),
      stream_(device) {}

ComputeKernel AdjointSolver::dots(const VertexVector& first, const VertexVector& second) {
  return {device_,
          adjoint_dots_comp_spirv,
          {{kBindingFirst, &first.texels()},
           {kBindingSecond, &second.texels()},
           {kBindingProducts, &sums_}},
          sizeof(DotsPush)};
}

void AdjointSolver::begin(const Matrix3Xd& rightSide) {
  descent_.takeHessian();
  remainder_.upload(device_, rightSide);
  stream_.begin();
  for (const Buffer* buffer : {&solution_.buffer(), &direction_.buffer(), &product_.buffer()}) {
    stream_.clear(*buffer);
  }
  stream_.end();
  stream_.submitAndWait();
}

AdjointSolver::Products AdjointSolver::run() {
  stream_.end();
  stream_.submitAndWait();
  Products total{0, 0};
  for (const vec2& sum : sums_.mapped<vec2>()) {
    total.mixed += sum.x;
    total.squared += sum.y;
  }
  return total;
}

AdjointSolver::Products AdjointSolver::multiply(double share) {
  const std::uint32_t groups = groupsFor(static_cast<int>(count_), kVectorInvocations);
  stream_.begin();
  stream_.dispatch(turn_, AdvancePush{count_, static_cast<float>(share)}, groups);
  descent_.cycle().hessian().record(stream_, multiplication_);
  stream_.dispatch(directionDots_, DotsPush{count_, reductionGroups(count_) * kVectorInvocations},
                   reductionGroups(count_));
  return run();
}

AdjointSolver::Products AdjointSolver::advance(double share) {
  const std::uint32_t groups = groupsFor(static_cast<int>(count_), kVectorInvocations);
  stream_.begin();
  stream_.dispatch(advance_, AdvancePush{count_, static_cast<float>(share)}, groups);
  descent_.cycle().record(stream_);
  stream_.dispatch(remainderDots_, DotsPush{count_, reductionGroups(count_) * kVectorInvocations},
                   reductionGroups(count_));
  return run();
}

Adjoint AdjointSolver::solve(const Matrix3Xd& rightSide, const AdjointOptions& options) {
  Adjoint result;
  result.lambda = Matrix3Xd::Zero(3, rightSide.cols());
  const double scale = rightSide.cwiseAbs().maxCoeff();
  if (scale == 0) {
    result.converged = true;
    return result;
  }
  begin(rightSide / scale);
  Products remainder = advance(0);
  const double first = remainder.squared;
  double share = 0;
  result.residual = 1;
  while (result.products < options.productLimit && result.residual > options.tolerance) {
    const double curvature = multiply(share).mixed;
    ++result.products;
    if (!(curvature > 0)) {
      break;
    }
    const double before = remainder.mixed;
    remainder = advance(before / curvature);
    share = remainder.mixed / before;
    result.residual = std::sqrt(remainder.squared / first);
  }
  result.converged = result.residual <= options.tolerance;
  result.lambda = scale * solution_.download(device_);
  return result;
}

}  // namespace morphgrid
