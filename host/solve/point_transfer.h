#pragma once
#include "solve/point_level.h"

namespace morphgrid {

/// How many points a level has whose every second point the next coarser one keeps, and the last.
PointGrid coarsened(PointGrid points);

/// Between a coarse level and the next coarser one: linked interpolation of rigid motions P
/// (shaders/solve/transfer.glsl), its transpose, and the Galerkin product. Rigid motions of the
/// whole and constant curvature come through exactly.
class PointTransfer {
 public:
  /// Keeps references. resolution: of the centres, see DeviceGrid.
  PointTransfer(const Device& device, PointKernels& kernels, const PointLevel& fine,
                const PointLevel& coarse, double resolution);
  PointTransfer(const PointTransfer&) = delete;

  /// Takes the fine level's centres: the coarse ones, and levers of the interpolation.
  void recordCentres(CommandStream& stream) const;
  /// The coarse matrix P^T A P.
  void recordProduct(CommandStream& stream) const;
  /// coarse.rightSide = P^T fine.result
  void recordRestriction(CommandStream& stream) const;
  /// fine.iterate += P coarse.result
  void recordProlongation(CommandStream& stream) const;

 private:
  TransferPush push() const;

  const Device& device_;
  const PointLevel& fine_;
  const PointLevel& coarse_;
  double resolution_;
  TexelBuffer levers_;
  ComputeKernel centresKernel_;
  PointKernel product_;
  PointKernel restriction_;
  PointKernel prolongation_;
};

}  // namespace morphgrid
