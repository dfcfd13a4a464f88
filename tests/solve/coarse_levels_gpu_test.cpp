#include "solve/coarse_levels.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "solve/coarsest_inverse.h"
#include "tests/solve/dense_hessian.h"
#include "tests/solve/dense_multigrid.h"
#include "tests/solve/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRounding = 1e-5;  // Rounding of single precision in sums of some hundred terms.

/// Bent over a saddle and shaken; a single layer stays in its plane.
StrutGrid unevenGrid(const GridShape& shape) {
  StrutGrid grid = bentGrid(shape, 5);
  grid.weights.angle = 0.7;
  if (shape.layers > 1) {
    for (Index n = 0; n < grid.positions.cols(); ++n) {
      auto x = grid.positions.col(n);
      x.z() += 0.03 * x.x() * x.x() - 0.02 * x.y() * x.y();
    }
  }
  const Matrix3Xd still = grid.positions;
  grid.positions = shaken(still, 0.05, 6);
  if (shape.layers == 1) {
    grid.positions.row(2) = still.row(2);
  }
  return grid;
}

/// Compressed everywhere: no tension, which would hold rotations.
StrutGrid compressedGrid(const GridShape& shape) {
  StrutGrid grid = unevenGrid(shape);
  forEachStrut(shape, [&](const Strut& strut) { valueAt(grid.rest, strut) *= 3; });
  return grid;
}

VectorXd randomVector(Index size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> component(-1, 1);
  return VectorXd::NullaryExpr(size, [&] { return component(random); });
}

/// Three numbers a vertex; a single layer is pulled in its plane only.
VectorXd randomForces(const GridShape& shape, unsigned seed) {
  VectorXd forces = randomVector(3 * shape.vertexCount(), seed);
  if (shape.layers == 1) {
    forces.reshaped(3, shape.vertexCount()).row(2).setZero();
  }
  return forces;
}

double relativeDifference(const MatrixXd& a, const MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / std::max(b.cwiseAbs().maxCoeff(), 1e-30);
}

Buffer vertexVector(const Device& device, const GridShape& shape) {
  using Usage = BufferUsage;
  return {
      device, shape.vertexCount() * sizeof(vec4),
      Usage::storageBuffer | Usage::storageTexelBuffer | Usage::transferSrc | Usage::transferDst,
      MemoryKind::device};
}

std::vector<vec4> packVertices(const VectorXd& values) {
  std::vector<vec4> packed;
  for (Index n = 0; n < values.size(); n += 3) {
    packed.emplace_back(values[n], values[n + 1], values[n + 2], 0);
  }
  return packed;
}

/// Approaches it by power iteration, from below.
double spectralRadius(const MatrixXd& matrix) {
  VectorXd x = randomVector(matrix.cols(), 4).normalized();
  double radius = 0;
  for (int n = 0; n < 100; ++n) {
    x = matrix * x;
    radius = x.norm();
    x /= radius;
  }
  return radius;
}

/// A grid's coarse levels on the device, beside the same in dense matrices.
struct Levels {
  Levels(const Device& onDevice, StrutGrid ofGrid, double damping = 0)
      : device(onDevice), grid(std::move(ofGrid)) {
    coarse.build(damping);
    prolongations.push_back(denseColumnProlongation(grid.shape, grid.positions / grid.spacing));
    centres.emplace_back((grid.positions / grid.spacing)
                             .middleCols(grid.shape.layers / 2 * grid.shape.layerVertexCount(),
                                         grid.shape.layerVertexCount()));
    for (std::size_t n = 0; n < coarse.transfers().size(); ++n) {
      const PointGrid points = coarse.levels()[n]->points();
      prolongations.push_back(densePointProlongation(points, centres[n]));
      centres.push_back(keptCentres(points, centres[n]));
    }
  }

  template <typename Record>
  void run(Record record) const {
    CommandStream stream(device);
    stream.begin();
    record(stream);
    stream.end();
    stream.submitAndWait();
  }

  VectorXd downloadCorrection() const {
    VectorXd values(3 * grid.shape.vertexCount());
    const auto packed = download<vec4>(device, correction, grid.shape.vertexCount());
    for (std::size_t n = 0; n < packed.size(); ++n) {
      values.segment<3>(static_cast<Index>(3 * n)) =
          Eigen::Vector3d(packed[n].x, packed[n].y, packed[n].z);
    }
    return values;
  }

  VectorXd cycle(const VectorXd& b, const VectorXd& start) const {
    upload(device, residual, packVertices(b));
    upload(device, correction, packVertices(start));
    run([&](CommandStream& stream) { coarse.recordCycle(stream); });
    return downloadCorrection();
  }

  const PointLevel& level(std::size_t n) const { return *coarse.levels()[n]; }

  const Device& device;
  StrutGrid grid;
  DeviceGrid deviceGrid{device, grid};
  Buffer residual = vertexVector(device, grid.shape);
  Buffer correction = vertexVector(device, grid.shape);
  CoarseLevels coarse{device, deviceGrid, deviceGrid.positions(), residual, correction};
  std::vector<MatrixXd> prolongations;  ///< [n] leads from levels()[n] to the one above.
  std::vector<Matrix3Xd> centres;       ///< Points of levels()[n], in spacings.
};

class CoarseLevelsTest : public DeviceTest, public testing::WithParamInterface<GridShape> {};

TEST_P(CoarseLevelsTest, ColumnMatrixIsTheGalerkinProduct) {
  const StrutGrid uneven = unevenGrid(GetParam());
  for (const auto& [grid, damping] :
       {std::pair(uneven, 0.0), {uneven, 0.3}, {withPrintedCorners(uneven), 0.0}}) {
    const Levels levels(device_, grid, damping);
    const MatrixXd hessian =
        denseHessian(levels.grid) + damping * denseLaplacian(levels.grid.shape);
    const MatrixXd& p = levels.prolongations.front();
    EXPECT_LT(
        relativeDifference(downloadMatrix(device_, levels.level(0)), p.transpose() * hessian * p),
        kRounding);
  }
}

TEST_P(CoarseLevelsTest, CoarserMatricesAreGalerkinProducts) {
  const Levels levels(device_, unevenGrid(GetParam()));
  for (std::size_t n = 1; n < levels.coarse.levels().size(); ++n) {
    const MatrixXd& p = levels.prolongations[n];
    const MatrixXd expected = p.transpose() * downloadMatrix(device_, levels.level(n - 1)) * p;
    EXPECT_LT(relativeDifference(downloadMatrix(device_, levels.level(n)), expected), kRounding)
        << "level " << n;
  }
}

TEST_P(CoarseLevelsTest, MatricesArePositiveSemidefinite) {
  const Levels levels(device_, unevenGrid(GetParam()));
  for (const auto& level : levels.coarse.levels()) {
    const MatrixXd matrix = downloadMatrix(device_, *level);
    EXPECT_LT(relativeDifference(matrix, matrix.transpose()), 1e-6);
    const VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<MatrixXd>(matrix).eigenvalues();
    EXPECT_GT(eigenvalues.minCoeff(), -1e-6 * eigenvalues.maxCoeff());
  }
}

TEST_P(CoarseLevelsTest, RigidMotionsCostNothing) {
  const Levels levels(device_, compressedGrid(GetParam()));
  for (std::size_t n = 0; n < levels.coarse.levels().size(); ++n) {
    const MatrixXd matrix = downloadMatrix(device_, levels.level(n));
    const MatrixXd rigid = orthonormalRigidMotions(levels.centres[n]);
    EXPECT_LT((matrix * rigid).cwiseAbs().maxCoeff(), kRounding * matrix.cwiseAbs().maxCoeff())
        << "level " << n;
  }
}

TEST_P(CoarseLevelsTest, RestrictionIsTheTransposeOfProlongation) {
  const Levels levels(device_, unevenGrid(GetParam()));
  const auto& transfers = levels.coarse.transfers();
  for (std::size_t n = 0; n < transfers.size(); ++n) {
    const PointLevel& fine = levels.level(n);
    const PointLevel& coarse = levels.level(n + 1);
    const MatrixXd& p = levels.prolongations[n + 1];
    const VectorXd ofFine = randomVector(p.rows(), 1);
    const VectorXd ofCoarse = randomVector(p.cols(), 2);
    uploadMotions(device_, fine.result(), ofFine);
    uploadMotions(device_, coarse.result(), ofCoarse);
    uploadMotions(device_, fine.iterate(), ofFine);
    levels.run([&](CommandStream& stream) {
      transfers[n]->recordRestriction(stream);
      transfers[n]->recordProlongation(stream);
    });
    EXPECT_LT(
        relativeDifference(downloadMotions(device_, coarse.rightSide()), p.transpose() * ofFine),
        kRounding);
    EXPECT_LT(relativeDifference(downloadMotions(device_, fine.iterate()), ofFine + p * ofCoarse),
              kRounding);
  }
}

TEST_P(CoarseLevelsTest, ColumnRestrictionIsTheTransposeOfProlongation) {
  const Levels levels(device_, unevenGrid(GetParam()));
  const MatrixXd& p = levels.prolongations.front();
  const VectorXd ofVertices = randomVector(p.rows(), 1);
  const VectorXd ofColumns = randomVector(p.cols(), 2);
  upload(device_, levels.residual, packVertices(ofVertices));
  upload(device_, levels.correction, packVertices(ofVertices));
  uploadMotions(device_, levels.level(0).result(), ofColumns);
  levels.run([&](CommandStream& stream) {
    levels.coarse.columnTransfer().recordRestriction(stream);
    levels.coarse.columnTransfer().recordProlongation(stream);
  });
  EXPECT_LT(relativeDifference(downloadMotions(device_, levels.level(0).rightSide()),
                               p.transpose() * ofVertices),
            kRounding);
  EXPECT_LT(relativeDifference(levels.downloadCorrection(), ofVertices + p * ofColumns), kRounding);
}

TEST_P(CoarseLevelsTest, ProlongationReproducesRigidMotions) {
  const Levels levels(device_, unevenGrid(GetParam()));
  const VectorXd motion = randomVector(6, 3);
  for (std::size_t n = 0; n < levels.coarse.transfers().size(); ++n) {
    const VectorXd expected = rigidMotion(levels.centres[n], motion);
    uploadMotions(device_, levels.level(n + 1).result(),
                  rigidMotion(levels.centres[n + 1], motion));
    uploadMotions(device_, levels.level(n).iterate(), VectorXd::Zero(expected.size()));
    levels.run(
        [&](CommandStream& stream) { levels.coarse.transfers()[n]->recordProlongation(stream); });
    EXPECT_LT(relativeDifference(downloadMotions(device_, levels.level(n).iterate()), expected),
              1e-6);
  }
}

// D may be singular: a column in one layer does not turn, nothing turns a straight one about
// itself.
TEST_P(CoarseLevelsTest, DiagonalBlocksAreInverted) {
  const Levels levels(device_, unevenGrid(GetParam()));
  for (std::size_t n = 0; n < levels.coarse.transfers().size(); ++n) {
    const MatrixXd matrix = downloadMatrix(device_, levels.level(n));
    const MatrixXd inverse = downloadInverse(device_, levels.level(n));
    EXPECT_LT(relativeDifference(inverse, inverse.transpose()), 1e-6);
    for (Index p = 0; p < matrix.rows(); p += 6) {
      const MatrixXd block = matrix.block<6, 6>(p, p);
      EXPECT_LT(relativeDifference(block * inverse.block<6, 6>(p, p) * block, block), 1e-4)
          << block << "\n\n"
          << inverse.block<6, 6>(p, p);
    }
  }
}

TEST_P(CoarseLevelsTest, SpectralRadiusOfSmoothingIsBounded) {
  const Levels levels(device_, unevenGrid(GetParam()));
  const int mostColumns = levels.deviceGrid.mostVertices();
  for (std::size_t n = 0; n < levels.coarse.transfers().size(); ++n) {
    const MatrixXd smoothed =
        downloadInverse(device_, levels.level(n)) * downloadMatrix(device_, levels.level(n));
    EXPECT_LT(spectralRadius(smoothed), n == 0 ? mostColumns + 0.001 : 4.001);
  }
}

TEST_P(CoarseLevelsTest, SmoothsAndTakesResiduals) {
  const Levels levels(device_, unevenGrid(GetParam()));
  for (std::size_t n = 0; n < levels.coarse.transfers().size(); ++n) {
    const PointLevel& level = levels.level(n);
    const MatrixXd matrix = downloadMatrix(device_, level);
    const MatrixXd step = level.smoothingWeight() * downloadInverse(device_, level);
    const VectorXd b = randomVector(matrix.rows(), 1);
    const VectorXd x = randomVector(matrix.rows(), 2);
    const auto after = [&](auto record, const TexelBuffer& result) {
      uploadMotions(device_, level.rightSide(), b);
      uploadMotions(device_, level.iterate(), x);
      levels.run(record);
      return downloadMotions(device_, result);
    };
    const auto first = [&](CommandStream& stream) { level.recordFirstSmoothing(stream); };
    EXPECT_LT(relativeDifference(after(first, level.iterate()), step * b), kRounding);
    const auto residual = [&](CommandStream& stream) { level.recordResidual(stream); };
    EXPECT_LT(relativeDifference(after(residual, level.result()), b - matrix * x), kRounding);
    const auto smoothing = [&](CommandStream& stream) { level.recordSmoothing(stream); };
    EXPECT_LT(relativeDifference(after(smoothing, level.result()), x + step * (b - matrix * x)),
              kRounding);
  }
}

/// One cycle as a matrix, from the device's matrices.
MatrixXd denseCycle(const Levels& levels, std::size_t n) {
  const PointLevel& level = levels.level(n);
  const MatrixXd a = downloadMatrix(levels.device, level);
  if (n + 1 == levels.coarse.levels().size()) {
    return computeCoarsestInverse(a, levels.centres[n], levels.centres[n].cols());
  }
  const MatrixXd smoothing = level.smoothingWeight() * downloadInverse(levels.device, level);
  const MatrixXd identity = MatrixXd::Identity(a.rows(), a.cols());
  const MatrixXd& p = levels.prolongations[n + 1];
  const MatrixXd coarse = p * denseCycle(levels, n + 1) * p.transpose();
  const MatrixXd corrected = smoothing + coarse * (identity - a * smoothing);
  return corrected + smoothing * (identity - a * corrected);
}

TEST_P(CoarseLevelsTest, CycleIsSymmetricAndThatOfDenseMatrices) {
  const Levels levels(device_, unevenGrid(GetParam()));
  const MatrixXd& p = levels.prolongations.front();
  const MatrixXd expected = p * denseCycle(levels, 0) * p.transpose();
  const VectorXd a = randomForces(GetParam(), 1);
  const VectorXd b = randomForces(GetParam(), 2);
  const VectorXd zero = VectorXd::Zero(p.rows());
  const VectorXd cycleOfA = levels.cycle(a, zero);
  const VectorXd cycleOfB = levels.cycle(b, zero);
  EXPECT_LT(relativeDifference(cycleOfA, expected * a), 1e-3);
  EXPECT_NEAR(cycleOfA.dot(b), cycleOfB.dot(a), 1e-4 * cycleOfA.norm() * b.norm());
  EXPECT_GT(cycleOfA.dot(a), 0);
}

TEST_P(CoarseLevelsTest, CycleAddsToTheCorrectionAndRepeatsItsBits) {
  const Levels levels(device_, unevenGrid(GetParam()));
  const VectorXd b = randomVector(3 * levels.grid.shape.vertexCount(), 1);
  const VectorXd start = randomVector(b.size(), 2);
  const VectorXd cycle = levels.cycle(b, VectorXd::Zero(b.size()));
  EXPECT_LT(relativeDifference(levels.cycle(b, start), start + cycle), kRounding);
  EXPECT_EQ(levels.cycle(b, VectorXd::Zero(b.size())), cycle);
}

INSTANTIATE_TEST_SUITE_P(Shapes, CoarseLevelsTest,
                         testing::Values(GridShape{2, 2, 1}, GridShape{3, 2, 2}, GridShape{5, 4, 3},
                                         GridShape{6, 6, 1}, GridShape{7, 3, 4}, GridShape{9, 8, 3},
                                         GridShape{21, 2, 2}, GridShape{10, 7, 1},
                                         GridShape{14, 9, 2}, GridShape{9, 17, 3},
                                         GridShape{8, 6, 6}),
                         [](const auto& shape) {
                           return std::to_string(shape.param.verticesU) + "x" +
                                  std::to_string(shape.param.verticesV) + "x" +
                                  std::to_string(shape.param.layers);
                         });

}  // namespace
}  // namespace morphgrid
