#pragma once
#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "gpu/buffer.h"
#include "grid/joint_rotations.h"
#include "grid/strut_grid.h"
#include "shared/frame_types.h"

namespace morphgrid {

/// All lateral struts as stiff as each other, all vertical ones too: the sweep need not load them.
struct UniformStiffness {
  float lateral;
  float vertical;  ///< 0 where there is a single layer.
};

/// Bars that are welded to their joints, see shaders/shared/frame_types.h.
struct DeviceFrame {
  DeviceBarSection lateral;
  DeviceBarSection upright;
  float lateralJoint;
  float uprightJoint;
  float holding = 0;  ///< Of joints that are held, see FramePush.
  float holdingAside = 0;
  float turning = 0;
};

/// A strut grid in the device's memory: what the kernels of shaders/solve and shaders/render read.
/// Lengths are in units of the spacing; positions are fixed-point, see
/// shaders/shared/solver_types.h.
class DeviceGrid {
 public:
  /// Uploads positions, rest lengths and stiffnesses. Throws InputError when the grid is not valid,
  /// DeviceError when it exceeds the device's limits.
  DeviceGrid(const Device& device, const StrutGrid& grid);

  /// Another grid of the same shape and kind, in the same buffers. Throws InputError when it is not
  /// valid.
  void assign(const StrutGrid& grid);

  /// The same buffers, with the scale of now: for another thread, which may draw while assign()
  /// changes it.
  std::shared_ptr<const DeviceGrid> onlooker() const;

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

  /// Whether its struts are welded bars, so that vertices turn too.
  bool isFrame() const { return mechanics_ == Mechanics::frame; }
  Mechanics mechanics() const { return mechanics_; }
  const DeviceFrame& frame() const { return *frame_; }
  /// Whether something acts on a frame's joints from outside, see JointLoads.
  bool isLoaded() const { return isLoaded_; }
  /// See morphgrid::freeMotions().
  const std::vector<int>& freeMotions() const { return freeMotions_; }
  /// Texels of a vector of the solver: one a vertex, and in frames another for its turn.
  int vectorLength() const { return (isFrame() ? 2 : 1) * shape_.vertexCount(); }

  /// ivec4 a vertex, in frames followed by the rotations. The solver swaps between two such
  /// buffers; this one holds the newest state before and after a solve.
  const Buffer& positions() const { return storage_->positions; }
  const Buffer& previousPositions() const { return storage_->previousPositions; }
  /// Whether positions() holds the newest state, or previousPositions(): for those who draw a solve
  /// that goes on.
  bool newestIsFirst() const { return storage_->newestIsFirst; }
  void noteNewest(bool isFirst) { storage_->newestIsFirst = isFirst; }
  /// ivec4 a vertex: rest lengths of the struts to +u, +v, +w in fixed point; step per force.
  const Buffer& rest() const { return storage_->rest; }
  /// vec4 a vertex: stiffnesses of the struts to +u, +v, +w.
  const Buffer& stiffness() const { return storage_->stiffness; }
  /// vec4 a vertex, unless corners rest at right angles: printed directions, see kBindingPrinted.
  const Buffer& printed() const { return storage_->printed; }
  /// vec4 a vertex of a frame that is loaded: the force on it; 1 where it is held.
  const Buffer& loads() const { return *storage_->loads; }
  /// ivec4 a vertex of a frame that is loaded: where it was printed, as positions().
  const Buffer& printedPositions() const { return *storage_->printedPositions; }
  /// Empty when stiffnesses differ.
  const std::optional<UniformStiffness>& uniformStiffness() const { return uniformStiffness_; }

  /// positions: 3 x vertexCount, in the scene's unit of length; both buffers get them (no
  /// velocity). rotations: of a frame's joints, which have not turned where there are none.
  void uploadPositions(const Eigen::Matrix3Xd& positions, const JointRotations& rotations = {});
  void uploadRest(const StrutValues& rest);
  Eigen::Matrix3Xd downloadPositions() const { return downloadPositions(positions()); }
  /// Positions, 3 x vertexCount, from another buffer of them. Uploading them again gives the same
  /// bits.
  Eigen::Matrix3Xd downloadPositions(const Buffer& from) const;
  /// The joints' rotations, none where the grid is no frame.
  JointRotations downloadRotations(const Buffer& from) const;

 private:
  struct Storage {
    Buffer positions;
    Buffer previousPositions;
    Buffer rest;
    Buffer stiffness;
    Buffer printed;
    std::optional<Buffer> loads;  ///< These two from the first grid on that is loaded.
    std::optional<Buffer> printedPositions;
    Eigen::VectorXd stepsPerForce;
    std::atomic<bool> newestIsFirst = true;

    Storage(const Device& device, const GridShape& shape, Mechanics mechanics);
  };

  DeviceGrid(const DeviceGrid&) = default;  // For onlooker().
  void take(const StrutGrid& grid);
  void takeBars(const StrutGrid& grid);
  /// positions: 3 x vertexCount. Throws InputError where one is out of reach.
  std::vector<ivec4> packed(const Eigen::Matrix3Xd& positions) const;

  const Device& device_;
  GridShape shape_;
  double resolution_;
  Mechanics mechanics_;
  double spacing_ = 1;
  std::optional<DeviceFrame> frame_;
  bool isLoaded_ = false;
  std::vector<int> freeMotions_;
  TermWeights weights_;
  int mostVertices_ = 0;
  double restResolution_ = 1;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  std::optional<UniformStiffness> uniformStiffness_;
  std::shared_ptr<Storage> storage_;
};

}  // namespace morphgrid
