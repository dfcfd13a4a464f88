#include "energy/exact_hessian.h"

#include "energy/energy_terms.h"

namespace morphgrid {

using Eigen::Matrix3Xd;

Matrix3Xd ExactHessian::product(const Matrix3Xd& motion) const {
  Matrix3Xd result = Matrix3Xd::Zero(3, motion.cols());
  forEachTerm(grid_, [&](const auto& term, const auto& stencil) {
    addToEnds(stencil,
              term.hessianProduct(differencesAlong(stencil, positions_),
                                  differencesAlong(stencil, motion)),
              result);
  });
  return result;
}

}  // namespace morphgrid
