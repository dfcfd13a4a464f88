#include "solve/grid_hessian.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <random>

#include "energy/exact_hessian.h"
#include "tests/solve/dense_hessian.h"
#include "tests/solve/sample_grids.h"
#include "tests/solve/vertex_vectors.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

enum class Stiffness { uniform, varied, variedWithPrintedCorners };

/// Struts in tension and in compression, corners off their right angles; in the plane where there
/// is a single layer.
StrutGrid strainedGrid(const GridShape& shape, Stiffness stiffness) {
  StrutGrid grid = bentGrid(shape, 3);
  grid.spacing = 1.25;
  grid.weights.angle = 0.7;
  grid.positions = shaken(1.1 * grid.positions, 0.15, 4);
  if (shape.layers == 1) {
    grid.positions.row(2).setZero();
  }
  std::mt19937 random(5);
  std::uniform_real_distribution<double> factor(0.5, 2);
  forEachStrut(shape, [&](const Strut& strut) {
    valueAt(grid.stiffness, strut) *= stiffness == Stiffness::uniform ? 1 : factor(random);
  });
  return stiffness == Stiffness::variedWithPrintedCorners ? withPrintedCorners(grid) : grid;
}

using Case = std::tuple<GridShape, Stiffness, LayerLoop>;

class GridHessianTest : public DeviceTest, public testing::WithParamInterface<Case> {
 protected:
  int vertexCount() const { return grid_.shape.vertexCount(); }
  VertexVector vector() const { return {device_, vertexCount()}; }

  VertexVector vector(const VectorXd& values) const {
    VertexVector result = vector();
    upload(device_, result.buffer(), packVector(values));
    return result;
  }

  VectorXd values(const VertexVector& vector) const {
    return unpackVector(download<vec4>(device_, vector.buffer(), vertexCount()));
  }

  void run(std::initializer_list<GridHessian::Step> steps) {
    stream_.begin();
    hessian_.recordLinearisation(stream_, deviceGrid_.positions());
    for (const GridHessian::Step& step : steps) {
      hessian_.record(stream_, step);
    }
    stream_.end();
    stream_.submitAndWait();
  }

  VectorXd random(unsigned seed) const {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> value(-1, 1);
    VectorXd result = VectorXd::NullaryExpr(3 * vertexCount(), [&] { return value(generator); });
    if (grid_.shape.layers == 1) {
      Matrix3Xd::Map(result.data(), 3, vertexCount()).row(2).setZero();
    }
    return result;
  }

  StrutGrid grid_ = strainedGrid(std::get<GridShape>(GetParam()), std::get<Stiffness>(GetParam()));
  DeviceGrid deviceGrid_{device_, grid_};
  GridHessian hessian_{device_, deviceGrid_, std::get<LayerLoop>(GetParam())};
  CommandStream stream_{device_};
  MatrixXd dense_ = denseHessian(grid_);
  const VectorXd x_ = random(1);
  const VectorXd b_ = random(2);
};

void expectClose(const VectorXd& actual, const VectorXd& expected) {
  ASSERT_TRUE(actual.allFinite());
  EXPECT_LT((actual - expected).cwiseAbs().maxCoeff(), 1e-5 * expected.cwiseAbs().maxCoeff());
}

TEST_P(GridHessianTest, ProductIsTheDenseOne) {
  const VertexVector x = vector(x_);
  const VertexVector y = vector();
  run({hessian_.product(x, y)});
  expectClose(values(y), dense_ * x_);
}

TEST_P(GridHessianTest, ExactProductIsTheOracles) {
  const VertexVector x = vector(x_);
  const VertexVector y = vector();
  run({hessian_.exactProduct(x, y)});
  const Matrix3Xd motion = Matrix3Xd::Map(x_.data(), 3, vertexCount());
  const Matrix3Xd expected = ExactHessian(grid_, grid_.positions).product(motion);
  expectClose(values(y), expected.reshaped());
}

TEST_P(GridHessianTest, ResidualIsTheDenseOne) {
  const VertexVector x = vector(x_);
  const VertexVector b = vector(b_);
  const VertexVector r = vector();
  run({hessian_.residual(x, b, r)});
  expectClose(values(r), b_ - dense_ * x_);
}

TEST_P(GridHessianTest, SmoothingIsTheDenseOne) {
  constexpr double kWeight = 0.55;
  hessian_.setSmoothingWeight(kWeight);
  const MatrixXd inverse = kWeight * invertedBlocks(diagonalBlocks(dense_));
  const VertexVector b = vector(b_);
  const VertexVector first = vector();
  const VertexVector residual = vector();
  const VertexVector second = vector();
  run({hessian_.firstSmoothing(b, first), hessian_.residual(first, b, residual),
       hessian_.smoothing(first, residual, second)});
  const VectorXd expected = inverse * b_;
  expectClose(values(first), expected);
  expectClose(values(second), expected + inverse * (b_ - dense_ * expected));
}

TEST_P(GridHessianTest, DampingAddsALaplacian) {
  constexpr double kDamping = 0.3;
  hessian_.setDamping(kDamping);
  const MatrixXd damped = dense_ + kDamping * denseLaplacian(grid_.shape);
  const VertexVector x = vector(x_);
  const VertexVector y = vector();
  const VertexVector z = vector();
  run({hessian_.product(x, y), hessian_.firstSmoothing(x, z)});
  expectClose(values(y), damped * x_);
  expectClose(values(z),
              2.0 / deviceGrid_.mostVertices() * invertedBlocks(diagonalBlocks(damped)) * x_);
}

// What makes the smoother converge.
TEST_P(GridHessianTest, SpectralRadiusIsBelowItsBound) {
  const MatrixXd inverse = invertedBlocks(diagonalBlocks(dense_));
  const double radius = (inverse * dense_).eigenvalues().cwiseAbs().maxCoeff();
  EXPECT_LE(radius, deviceGrid_.mostVertices());
  EXPECT_GT(radius, 0.5 * deviceGrid_.mostVertices());
}

// They fill neither blocks of columns nor workgroups; layers beyond those that are unrolled.
INSTANTIATE_TEST_SUITE_P(OddShapes, GridHessianTest,
                         testing::Combine(testing::Values(GridShape{2, 2, 1}, GridShape{3, 2, 2},
                                                          GridShape{5, 4, 3}, GridShape{7, 3, 4},
                                                          GridShape{6, 6, 1}, GridShape{19, 3, 2},
                                                          GridShape{3, 4, 6}),
                                          testing::Values(Stiffness::uniform, Stiffness::varied,
                                                          Stiffness::variedWithPrintedCorners),
                                          testing::Values(LayerLoop::unrolled)));

INSTANTIATE_TEST_SUITE_P(Rolled, GridHessianTest,
                         testing::Combine(testing::Values(GridShape{6, 5, 1}, GridShape{5, 4, 3}),
                                          testing::Values(Stiffness::uniform),
                                          testing::Values(LayerLoop::rolled)));

}  // namespace
}  // namespace morphgrid
