#include "energy/exact_hessian.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "energy/strut_energy.h"
#include "tests/solve/dense_hessian.h"
#include "tests/solve/sample_grids.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;

class ExactHessianOfShapes : public testing::TestWithParam<GridShape> {
 protected:
  ExactHessianOfShapes() { grid_.positions = shaken(grid_.positions, 0.1, 5); }

  Matrix3Xd randomMotion(unsigned seed) const {
    return shaken(Matrix3Xd::Zero(3, grid_.positions.cols()), 1, seed);
  }

  StrutGrid grid_ = bentGrid(GetParam(), 3);
  StrutEnergy energy_{grid_};
  ExactHessian hessian_{grid_, grid_.positions};
};

TEST_P(ExactHessianOfShapes, AgreesWithDifferencesOfTheGradient) {
  const MatrixXd dense = denseExactHessian(grid_);
  const Matrix3Xd z = randomMotion(7);
  const Eigen::VectorXd expected = dense * z.reshaped();
  EXPECT_LT((hessian_.product(z).reshaped() - expected).norm(), 1e-7 * expected.norm());
}

TEST_P(ExactHessianOfShapes, IsSymmetric) {
  const Matrix3Xd y = randomMotion(1);
  const Matrix3Xd z = randomMotion(2);
  const double there = y.cwiseProduct(hessian_.product(z)).sum();
  const double back = z.cwiseProduct(hessian_.product(y)).sum();
  EXPECT_NEAR(there, back, 1e-13 * hessian_.product(z).norm() * y.norm());
}

// g(R x) = R g(x) and g(x + t) = g(x), differentiated.
TEST_P(ExactHessianOfShapes, RigidMotionsTurnTheGradient) {
  const Matrix3Xd gradient = energy_.evaluate(grid_.positions).gradient;
  const Vector3d axis(0.3, -1, 0.7);
  const Matrix3Xd turned = -grid_.positions.colwise().cross(axis);
  const Matrix3Xd expected = -gradient.colwise().cross(axis);
  EXPECT_LT((hessian_.product(turned) - expected).norm(), 1e-12 * turned.norm());
  const Matrix3Xd shifted = axis.replicate(1, grid_.positions.cols());
  EXPECT_LT(hessian_.product(shifted).norm(), 1e-12 * shifted.norm());
}

INSTANTIATE_TEST_SUITE_P(Shapes, ExactHessianOfShapes,
                         testing::Values(GridShape{2, 2, 1}, GridShape{5, 3, 1}, GridShape{2, 2, 2},
                                         GridShape{4, 5, 3}));

TEST(ExactHessian, CollinearArmsStayFinite) {
  StrutGrid grid = bentGrid({2, 2, 1}, 0);
  grid.positions.col(3) = Vector3d(3, 0, 0);
  grid.positions.col(2) = Vector3d(2, 0, 0);
  const Matrix3Xd z = shaken(Matrix3Xd::Zero(3, 4), 1, 1);
  EXPECT_TRUE(ExactHessian(grid, grid.positions).product(z).allFinite());
}

}  // namespace
}  // namespace morphgrid
