#pragma once
#include <atomic>
#include <optional>

#include "gpu/buffer.h"
#include "grid/strut_grid.h"

namespace morphgrid {

/// All lateral struts as stiff as each other, all vertical ones too: the sweep need not load them.
struct UniformStiffness {
  float lateral;
  float vertical;  ///< 0 where there is a single layer.
};

/// A strut grid in the device's memory: what the kernels of shaders/solve and shaders/render read.
/// Lengths are in units of the spacing; positions are fixed-point, see
/// shaders/shared/solver_types.h.
class DeviceGrid {
 public:
  /// Uploads positions, rest lengths and stiffnesses. Throws InputError when the grid is not valid,
  /// DeviceError when it exceeds the device's limits.
  DeviceGrid(const Device& device, const StrutGrid& grid);

  const GridShape& shape() const { return shape_; }
  double spacing() const { return spacing_; }
  const TermWeights& weights() const { return weights_; }
  /// See StrutEnergy::mostVertices().
  int mostVertices() const { return mostVertices_; }
  /// Spacings per step of the fixed-point positions, a power of two.
  double resolution() const { return resolution_; }
  /// Spacings per step of the fixed-point rest lengths, a power of two.
  double restResolution() const { return restResolution_; }
  /// What the fixed-point zero stands for, in the scene's unit of length.
  const Eigen::Vector3d& origin() const { return origin_; }

  /// ivec4 a vertex. The solver swaps between two such buffers; this one holds the newest state
  /// before and after a solve.
  const Buffer& positions() const { return positions_; }
  const Buffer& previousPositions() const { return previousPositions_; }
  /// Whether positions() holds the newest state, or previousPositions(): for those who draw a solve
  /// that goes on.
  bool newestIsFirst() const { return newestIsFirst_; }
  void noteNewest(bool isFirst) { newestIsFirst_ = isFirst; }
  /// ivec4 a vertex: rest lengths of the struts to +u, +v, +w in fixed point; step per force.
  const Buffer& rest() const { return rest_; }
  /// vec4 a vertex: stiffnesses of the struts to +u, +v, +w.
  const Buffer& stiffness() const { return stiffness_; }
  /// Empty when stiffnesses differ.
  const std::optional<UniformStiffness>& uniformStiffness() const { return uniformStiffness_; }

  /// positions: 3 x vertexCount, in the scene's unit of length; both buffers get them (no
  /// velocity).
  void uploadPositions(const Eigen::Matrix3Xd& positions);
  void uploadRest(const StrutValues& rest);
  Eigen::Matrix3Xd downloadPositions() const { return downloadPositions(positions_); }
  /// Positions, 3 x vertexCount, from another buffer of them. Uploading them again gives the same
  /// bits.
  Eigen::Matrix3Xd downloadPositions(const Buffer& from) const;

 private:
  const Device& device_;
  GridShape shape_;
  double spacing_;
  TermWeights weights_;
  int mostVertices_ = 0;
  double resolution_;
  double restResolution_;
  Eigen::Vector3d origin_;
  Eigen::VectorXd stepsPerForce_;
  std::optional<UniformStiffness> uniformStiffness_;
  Buffer positions_;
  Buffer previousPositions_;
  Buffer rest_;
  Buffer stiffness_;
  std::atomic<bool> newestIsFirst_ = true;
};

}  // namespace morphgrid
