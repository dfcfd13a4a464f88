#pragma once
#include "solve/column_walk.h"
#include "solve/frame_kernels.h"
#include "solve/point_level.h"

namespace morphgrid {

/// Between the vertices and level 1, whose points are columns of vertices that move rigidly about
/// the vertex in their middle layer: u(x) = t + w x (x - centre).
class ColumnTransfer {
 public:
  /// positions: the linearisation point, as DeviceGrid::positions(). residual, correction: vec4 a
  /// vertex. All of them are read as storage texels, correction is written too. Keeps references.
  ColumnTransfer(const Device& device, const DeviceGrid& grid, const PointLevel& columns,
                 const Buffer& positions, const Buffer& residual, const Buffer& correction);
  ColumnTransfer(const ColumnTransfer&) = delete;

  void recordCentres(CommandStream& stream) const;
  /// The columns' matrix P^T H P, H the Gauss-Newton Hessian and `damping` times the Laplacian
  /// whose edges weigh 1.
  void recordMatrix(CommandStream& stream, double damping) const;
  /// columns.rightSide = P^T residual
  void recordRestriction(CommandStream& stream) const;
  /// correction += P columns.result
  void recordProlongation(CommandStream& stream) const;

 private:
  ColumnPush push(double damping) const;
  KernelFamily family(ShaderCode spirv) const;
  PointKernel matrixKernel() const;
  PointKernel kernel(KernelFamily kernels, std::vector<KernelResource> resources) const;

  const Device& device_;
  const DeviceGrid& grid_;
  const PointLevel& columns_;
  const Buffer& positions_;
  TexelView positionTexels_;
  TexelView residualTexels_;
  TexelView correctionTexels_;
  GridTexels gridTexels_;
  std::optional<FrameColumns> frame_;  ///< Of grids that are frames.
  PointKernel matrix_;
  PointKernel restriction_;
  ComputeKernel prolongation_;
};

}  // namespace morphgrid
