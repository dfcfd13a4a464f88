#pragma once
#include <Eigen/Core>
#include <memory>

#include "solve/column_transfer.h"
#include "solve/point_transfer.h"

namespace morphgrid {

/// The points of the level that is solved directly.
PointGrid coarsestPoints(const GridShape& shape);

/// All levels of multigrid but the finest: columns of vertices that move rigidly, then every second
/// of their rigid motions, and so on, each with a matrix P^T A P of the level above; the coarsest
/// one is solved directly. Everything is allocated once; two runs on one device give the same bits.
class CoarseLevels {
 public:
  /// positions: where H is taken, as DeviceGrid::positions(); to be left alone from a build() to
  /// the last of its cycles. residual, correction: vec4 a vertex. All three with the usage
  /// storageTexelBuffer, positions with transferSrc and correction with storageBuffer too. Keeps
  /// references. Throws DeviceError when the device's limits are exceeded.
  CoarseLevels(const Device& device, const DeviceGrid& grid, const Buffer& positions,
               const Buffer& residual, const Buffer& correction);

  /// Assembles all matrices at the positions, with `damping` times the Laplacian whose edges weigh
  /// 1 added to H; waits.
  void build(double damping = 0);

  /// correction += P x, where A x = P^T residual is solved about, by one V-cycle: symmetric, with
  /// one step of block-Jacobi before and after.
  void recordCycle(CommandStream& stream) const;

  /// levels()[0] has a point per column.
  const std::vector<std::unique_ptr<const PointLevel>>& levels() const { return levels_; }
  const ColumnTransfer& columnTransfer() const { return *columnTransfer_; }
  /// [n] leads from levels()[n] to the next coarser one.
  const std::vector<std::unique_ptr<const PointTransfer>>& transfers() const { return transfers_; }

 private:
  void createLevels(const DeviceGrid& grid);
  void recordBuild(double damping);
  void invertCoarsest();
  Eigen::MatrixXd coarsestMatrix() const;
  Eigen::Matrix3Xd coarsestCentres() const;
  void recordCoarsest(CommandStream& stream) const;

  const Device& device_;
  double resolution_;
  std::vector<int> freeMotions_;
  CommandStream stream_;
  PointKernels kernels_;
  std::vector<std::unique_ptr<const PointLevel>> levels_;
  std::unique_ptr<const ColumnTransfer> columnTransfer_;
  std::vector<std::unique_ptr<const PointTransfer>> transfers_;
  std::unique_ptr<const TexelBuffer> coarsestInverse_;
  std::unique_ptr<const ComputeKernel> coarsestSolve_;
};

}  // namespace morphgrid
