#include "inverse/lateral_rest.h"

namespace morphgrid {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

LateralRest::LateralRest(const GridShape& shape) {
  for (const Strut& strut : listStruts(shape)) {
    if (strut.direction != Strut::Direction::w) {
      struts_.push_back(strut);
    }
  }
}

VectorXd LateralRest::of(const StrutGrid& grid) const {
  return VectorXd::NullaryExpr(size(), [&](Eigen::Index n) {
    return valueAt(grid.rest, struts_[static_cast<std::size_t>(n)]);
  });
}

void LateralRest::set(StrutGrid& grid, const VectorXd& lengths) const {
  for (Eigen::Index n = 0; n < size(); ++n) {
    valueAt(grid.rest, struts_[static_cast<std::size_t>(n)]) = lengths[n];
  }
}

StrutValues LateralRest::replacedIn(const StrutGrid& grid, const VectorXd& lengths) const {
  StrutValues rest = grid.rest;
  for (Eigen::Index n = 0; n < size(); ++n) {
    valueAt(rest, struts_[static_cast<std::size_t>(n)]) = lengths[n];
  }
  return rest;
}

VectorXd LateralRest::lengthsAt(const Matrix3Xd& positions) const {
  return VectorXd::NullaryExpr(size(), [&](Eigen::Index n) {
    const Strut& strut = struts_[static_cast<std::size_t>(n)];
    return (positions.col(strut.to) - positions.col(strut.from)).norm();
  });
}

VectorXd LateralRest::gradient(const StrutGrid& grid, const Matrix3Xd& equilibrium,
                               const Matrix3Xd& lambda) const {
  return VectorXd::NullaryExpr(size(), [&](Eigen::Index n) {
    const Strut& strut = struts_[static_cast<std::size_t>(n)];
    const Vector3d e = equilibrium.col(strut.to) - equilibrium.col(strut.from);
    const Vector3d change = lambda.col(strut.to) - lambda.col(strut.from);
    return 2 * valueAt(grid.stiffness, strut) * e.normalized().dot(change);
  });
}

}  // namespace morphgrid
