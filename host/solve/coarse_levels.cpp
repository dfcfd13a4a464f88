#include "solve/coarse_levels.h"

#include <algorithm>
#include <cmath>

#include "solve/coarsest_inverse.h"
#include "solve/coarsest_solve_comp.h"

namespace morphgrid {
namespace {

/// So few points are solved directly: inverting their matrix, in time that grows with their number
/// to the power 2.5, takes the host less than a cycle takes the device. More would spare cycles,
/// but the inverse takes memory that grows with their square.
bool areSolvedDirectly(const PointGrid& points, const GridShape& shape) {
  constexpr int kLeast = 36;
  constexpr double kPerCubeRoot = 4.4;
  const int most =
      std::max(kLeast, static_cast<int>(kPerCubeRoot * std::cbrt(shape.vertexCount())));
  return points.count() <= most || coarsened(points) == points;
}

/// A term within one cell of the columns depends on at most four points of a coarser level, so no
/// eigenvalue of D^-1 A is larger there. It spans at most as many columns as vertices.
constexpr double kPointSpectralRadius = 4;

using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// As shaders/shared/multigrid_types.h lays it out.
Matrix6d blockAt(const BlockField& field, int point) {
  Matrix6d block;
  for (int n = 0; n < int(kBlockParts * kPartTexels); ++n) {
    const int column = n % 3;
    const int quarter = n / 3;
    const vec4 texel = field.part(static_cast<std::size_t>(quarter))
                           .buffer()
                           .mapped<vec4>()[3 * std::size_t(point) + std::size_t(column)];
    const int firstRow = quarter == 2 ? 3 : 0;
    const int firstColumn = quarter == 1 ? 3 : 0;
    for (int row = 0; row < 3; ++row) {
      block(firstRow + row, firstColumn + column) = texel[row];
    }
    block(3 + column, 3 + quarter) = texel.w;
  }
  return block;
}

/// From a point to the one whose motion the block multiplies.
Eigen::Vector2i stencilOffset(std::uint32_t direction) {
  switch (direction) {
    case kStencilEast:
      return {1, 0};
    case kStencilNorth:
      return {0, 1};
    case kStencilNorthEast:
      return {1, 1};
    case kStencilNorthWest:
      return {-1, 1};
    default:
      return {0, 0};
  }
}

/// In the order in which coarsest_solve.comp reads it.
std::vector<vec4> packInverse(const Eigen::MatrixXd& inverse) {
  const Eigen::Index halfMotions = inverse.rows() / 3;
  std::vector<vec4> packed;
  packed.reserve(static_cast<std::size_t>(3 * halfMotions * halfMotions));
  for (Eigen::Index m = 0; m < halfMotions; ++m) {
    for (Eigen::Index n = 0; n < 3; ++n) {
      for (Eigen::Index half = 0; half < halfMotions; ++half) {
        const Eigen::Vector3f row = inverse.block<1, 3>(3 * half + n, 3 * m).cast<float>();
        packed.emplace_back(row.x(), row.y(), row.z(), 0);
      }
    }
  }
  return packed;
}

}  // namespace

PointGrid coarsestPoints(const GridShape& shape) {
  PointGrid points{shape.verticesU, shape.verticesV};
  while (!areSolvedDirectly(points, shape)) {
    points = coarsened(points);
  }
  return points;
}

CoarseLevels::CoarseLevels(const Device& device, const DeviceGrid& grid, const Buffer& positions,
                           const Buffer& residual, const Buffer& correction)
    : device_(device),
      resolution_(grid.resolution()),
      freeMotions_(grid.freeMotions()),
      stream_(device),
      kernels_(device) {
  createLevels(grid);
  columnTransfer_ = std::make_unique<const ColumnTransfer>(device, grid, *levels_.front(),
                                                           positions, residual, correction);
  for (std::size_t n = 1; n < levels_.size(); ++n) {
    transfers_.push_back(std::make_unique<const PointTransfer>(device, kernels_, *levels_[n - 1],
                                                               *levels_[n], resolution_));
  }
  const PointLevel& coarsest = *levels_.back();
  const auto halfMotions = static_cast<std::size_t>(2 * coarsest.points().count());
  coarsestInverse_ = std::make_unique<const TexelBuffer>(device, 3 * halfMotions * halfMotions,
                                                         TexelFormat::float4, MemoryKind::device);
  const std::vector<KernelResource> resources{
      {kBindingCoarsestInverse, &coarsestInverse_->texels()},
      {kBindingRightSide, &coarsest.rightSide().texels()},
      {kBindingResult, &coarsest.result().buffer()}};
  coarsestSolve_ = std::make_unique<const ComputeKernel>(
      device, coarsest_solve_comp_spirv, resources, std::uint32_t{sizeof(CoarsestPush)},
      std::vector<std::uint32_t>{device.subgroupSize()});
}

void CoarseLevels::createLevels(const DeviceGrid& grid) {
  PointGrid points{grid.shape().verticesU, grid.shape().verticesV};
  for (double bound = grid.mostVertices();; bound = kPointSpectralRadius) {
    const bool coarsest = areSolvedDirectly(points, grid.shape());
    levels_.push_back(std::make_unique<const PointLevel>(
        device_, kernels_, points, coarsest ? MemoryKind::host : MemoryKind::device, bound));
    if (coarsest) {
      return;
    }
    points = coarsened(points);
  }
}

void CoarseLevels::recordBuild(double damping) {
  stream_.begin();
  columnTransfer_->recordCentres(stream_);
  columnTransfer_->recordMatrix(stream_, damping);
  for (std::size_t n = 0; n < transfers_.size(); ++n) {
    levels_[n]->recordInversion(stream_);
    transfers_[n]->recordCentres(stream_);
    transfers_[n]->recordProduct(stream_);
  }
  stream_.end();
}

void CoarseLevels::build(double damping) {
  recordBuild(damping);
  stream_.submitAndWait();
  invertCoarsest();
}

void CoarseLevels::invertCoarsest() {
  upload(device_, coarsestInverse_->buffer(),
         packInverse(computeCoarsestInverse(coarsestMatrix(), coarsestCentres(),
                                            levels_.back()->points().u, freeMotions_)));
}

Eigen::MatrixXd CoarseLevels::coarsestMatrix() const {
  const PointLevel& level = *levels_.back();
  const PointGrid points = level.points();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(6 * points.count(), 6 * points.count());
  for (std::uint32_t direction = 0; direction < kStencilSize; ++direction) {
    const Eigen::Vector2i offset = stencilOffset(direction);
    for (int j = 0; j < points.v; ++j) {
      for (int i = 0; i < points.u; ++i) {
        const int u = i + offset.x();
        const int v = j + offset.y();
        if (u < 0 || u >= points.u || v >= points.v) {
          continue;
        }
        const int row = j * points.u + i;
        const Matrix6d block = blockAt(level.blocks(direction), row);
        matrix.block<6, 6>(Eigen::Index(6) * row, Eigen::Index(6) * (v * points.u + u)) += block;
        matrix.block<6, 6>(Eigen::Index(6) * (v * points.u + u), Eigen::Index(6) * row) +=
            block.transpose();
      }
    }
  }
  for (Eigen::Index n = 0; n < matrix.rows(); n += 6) {
    matrix.block<6, 6>(n, n) /= 2;  // Was added twice.
  }
  return matrix;
}

Eigen::Matrix3Xd CoarseLevels::coarsestCentres() const {
  const PointLevel& level = *levels_.back();
  const auto packed = level.centres().buffer().mapped<ivec4>();
  Eigen::Matrix3Xd centres(3, level.points().count());
  for (Eigen::Index n = 0; n < centres.cols(); ++n) {
    const ivec4& centre = packed[static_cast<std::size_t>(n)];
    centres.col(n) = resolution_ * Eigen::Vector3d(centre.x, centre.y, centre.z);
  }
  return centres;
}

void CoarseLevels::recordCoarsest(CommandStream& stream) const {
  const CoarsestPush push{2 * levels_.back()->points().count()};
  dispatchPoints(device_, stream, *coarsestSolve_, push, {push.halfMotions, 1});
}

void CoarseLevels::recordCycle(CommandStream& stream) const {
  columnTransfer_->recordRestriction(stream);
  for (std::size_t n = 0; n < transfers_.size(); ++n) {
    levels_[n]->recordFirstSmoothing(stream);
    levels_[n]->recordResidual(stream);
    transfers_[n]->recordRestriction(stream);
  }
  recordCoarsest(stream);
  for (std::size_t n = transfers_.size(); n-- > 0;) {
    transfers_[n]->recordProlongation(stream);
    levels_[n]->recordSmoothing(stream);
  }
  columnTransfer_->recordProlongation(stream);
}

}  // namespace morphgrid
