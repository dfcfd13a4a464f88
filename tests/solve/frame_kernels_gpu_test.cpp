#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "energy/beam_term.h"
#include "energy/frame_energy.h"
#include "solve/coarse_levels.h"
#include "solve/frame_hessian.h"
#include "solve/grid_gradient.h"
#include "tests/solve/frame_grids.h"
#include "tests/solve/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;

constexpr BarSize kThick{.width = 0.25, .height = 0.2, .poisson = 0.4, .joint = 0.05};
constexpr BarSize kSlender{
    .width = 0.1, .height = 0.1, .poisson = 0.3, .joint = 0, .isShearing = false};

enum class Held { notAtAll, clamped, sliding };

/// Kernels of a frame away from rest, beside the host's double precision.
class FrameKernels : public DeviceTest,
                     public testing::WithParamInterface<std::tuple<GridShape, BarSize, Held>> {
 protected:
  void SetUp() override { deviceGrid_.uploadPositions(place_.positions, place_.rotations); }

  int count() const { return grid_.shape.vertexCount(); }
  VertexVector vector() const { return {device_, deviceGrid_.vectorLength()}; }

  /// A vector of unknowns, as the device has it: displacements in spacings.
  Matrix3Xd motion(unsigned seed) const { return shaken(Matrix3Xd::Zero(3, 2 * count()), 1, seed); }

  /// From the host's unit to the device's, and back for motions.
  Matrix3Xd onDevice(const Matrix3Xd& gradient) const {
    Matrix3Xd result = gradient / (grid_.spacing * grid_.spacing);
    result.leftCols(count()) *= grid_.spacing;
    return result;
  }
  Matrix3Xd inScene(Matrix3Xd motion) const {
    motion.leftCols(count()) *= grid_.spacing;
    return motion;
  }

  Matrix3Xd run(Hessian& hessian, const Hessian::Step& step, const VertexVector& result) const {
    CommandStream stream(device_);
    stream.begin();
    hessian.recordLinearisation(stream, deviceGrid_.positions());
    hessian.record(stream, step);
    stream.end();
    stream.submitAndWait();
    return result.download(device_);
  }

  /// The Gauss-Newton Hessian of 6 unknowns a joint, in the device's units, in the order of
  /// vectors.
  MatrixXd denseGaussNewton() const {
    const int size = 6 * count();
    MatrixXd dense = MatrixXd::Zero(size, size);
    BeamTerm::forEach(grid_, [&](const BeamTerm& term, const Edge& edge) {
      const auto ends = term.endsAt(place_.positions.col(edge.to) - place_.positions.col(edge.from),
                                    Eigen::Quaterniond(place_.rotations.col(edge.from)),
                                    Eigen::Quaterniond(place_.rotations.col(edge.to)));
      MatrixXd spread = MatrixXd::Zero(9, size);
      spread.block<3, 3>(0, 3 * edge.to).diagonal().setConstant(grid_.spacing);
      spread.block<3, 3>(0, 3 * edge.from).diagonal().setConstant(-grid_.spacing);
      spread.block<3, 3>(3, 3 * (count() + edge.from)).setIdentity();
      spread.block<3, 3>(6, 3 * (count() + edge.to)).setIdentity();
      dense +=
          spread.transpose() * term.gaussNewton(ends) * spread / (grid_.spacing * grid_.spacing);
    });
    JointTerm::forEach(grid_, [&](const JointTerm& term, int joint) {
      dense.diagonal().segment<3>(3 * joint) += term.holding;
      dense.diagonal().segment<3>(3 * (count() + joint)).array() +=
          term.turning / (grid_.spacing * grid_.spacing);
    });
    return dense;
  }

  static StrutGrid frame() {
    StrutGrid grid = bentGrid(std::get<GridShape>(GetParam()), 3);
    grid.spacing = 1.25;
    grid = welded(grid, std::get<BarSize>(GetParam()));
    const Held held = std::get<Held>(GetParam());
    return held == Held::notAtAll
               ? grid
               : weighedDown(grid, {0.01, 0.02, -0.05}, {1, 2}, held == Held::sliding);
  }

  StrutGrid grid_ = frame();
  DeviceGrid deviceGrid_{device_, grid_};
  FramePlace place_ = shakenFrame(grid_, 0.1, 0.15, 5);
};

void expectClose(const MatrixXd& actual, const MatrixXd& expected, double tolerance) {
  EXPECT_LT((actual - expected).norm(), tolerance * expected.norm());
}

TEST_P(FrameKernels, GradientIsTheHosts) {
  for (const Precision precision : {Precision::single, Precision::precise}) {
    if (precision == Precision::precise && !device_.hasFloat64()) {
      continue;
    }
    GridGradient gradient(device_, deviceGrid_, precision);
    const VertexVector result = vector();
    const auto evaluation = gradient.evaluation(deviceGrid_.positions(), result);
    CommandStream stream(device_);
    stream.begin();
    gradient.record(stream, evaluation);
    stream.end();
    stream.submitAndWait();
    const auto host = FrameEnergy(grid_).evaluate(place_.positions, place_.rotations);
    const Matrix3Xd expected = onDevice(host.gradient);
    const bool isPrecise = precision == Precision::precise;
    expectClose(result.download(device_), expected, isPrecise ? 3e-7 : 1e-5);
    const double energy = host.energy / (grid_.spacing * grid_.spacing);
    EXPECT_NEAR(gradient.sums().energy, energy, (isPrecise ? 3e-7 : 1e-5) * energy);
    EXPECT_NEAR(gradient.sums().squaredNorm, expected.squaredNorm(), 1e-5 * expected.squaredNorm());
  }
}

TEST_P(FrameKernels, GaussNewtonProductIsTheDenseOne) {
  FrameHessian hessian(device_, deviceGrid_);
  const VertexVector z = vector(), y = vector();
  const Matrix3Xd motion = this->motion(7);
  z.upload(device_, motion);
  const Matrix3Xd product = run(hessian, hessian.product(z, y), y);
  expectClose(product.reshaped(), denseGaussNewton() * motion.reshaped(), 2e-5);
}

TEST_P(FrameKernels, ExactProductIsTheHosts) {
  FrameHessian hessian(device_, deviceGrid_);
  const VertexVector z = vector(), y = vector();
  const Matrix3Xd motion = this->motion(7);
  z.upload(device_, motion);
  const Matrix3Xd product = run(hessian, hessian.exactProduct(z, y), y);
  const Matrix3Xd expected =
      FrameEnergy(grid_).hessianProduct(place_.positions, place_.rotations, inScene(motion));
  expectClose(product, onDevice(expected), 2e-5);
}

TEST_P(FrameKernels, SmoothingIsTheDenseOne) {
  FrameHessian hessian(device_, deviceGrid_);
  hessian.setSmoothingWeight(0.5);
  const VertexVector z = vector(), b = vector(), r = vector(), next = vector();
  const Matrix3Xd iterate = motion(8), right = motion(9);
  z.upload(device_, iterate);
  b.upload(device_, right);
  const MatrixXd dense = denseGaussNewton();
  const Matrix3Xd residual = run(hessian, hessian.residual(z, b, r), r);
  const Matrix3Xd expected = right - (dense * iterate.reshaped()).reshaped(3, 2 * count());
  expectClose(residual, expected, 2e-5);
  Matrix3Xd smoothed = iterate;
  for (int n = 0; n < count(); ++n) {
    Eigen::Matrix<double, 6, 6> block;
    const int at[2] = {3 * n, 3 * (count() + n)};
    for (int row = 0; row < 2; ++row) {
      for (int column = 0; column < 2; ++column) {
        block.block<3, 3>(3 * row, 3 * column) = dense.block<3, 3>(at[row], at[column]);
      }
    }
    Eigen::Matrix<double, 6, 1> own;
    own << residual.col(n), residual.col(count() + n);
    const Eigen::Matrix<double, 6, 1> step = 0.5 * block.ldlt().solve(own);
    smoothed.col(n) += step.head<3>();
    smoothed.col(count() + n) += step.tail<3>();
  }
  expectClose(run(hessian, hessian.smoothing(z, r, next), next), smoothed, 1e-3);
}

TEST_P(FrameKernels, SpectralRadiusIsBelowTwo) {
  const MatrixXd dense = denseGaussNewton();
  MatrixXd blocks = MatrixXd::Zero(dense.rows(), dense.cols());
  for (int n = 0; n < count(); ++n) {
    const int at[2] = {3 * n, 3 * (count() + n)};
    for (const int row : at) {
      for (const int column : at) {
        blocks.block<3, 3>(row, column) = dense.block<3, 3>(row, column);
      }
    }
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> eigen(dense, blocks);
  EXPECT_LT(eigen.eigenvalues().maxCoeff(), 2 + 1e-9);
}

TEST_P(FrameKernels, RotationsComeBackFromTheDevice) {
  const JointRotations back = deviceGrid_.downloadRotations(deviceGrid_.positions());
  EXPECT_LT((back - place_.rotations).cwiseAbs().maxCoeff(), 2e-9);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, FrameKernels,
    testing::Combine(testing::Values(GridShape{4, 3, 2}, GridShape{2, 2, 1}, GridShape{11, 5, 3}),
                     testing::Values(kThick, kSlender),
                     testing::Values(Held::notAtAll, Held::clamped, Held::sliding)));

}  // namespace
}  // namespace morphgrid
