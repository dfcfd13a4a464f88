#pragma once
#include "app/restored_run.h"
#include "app/snapshot_board.h"

namespace morphgrid {

/// Posts what a run does, for a viewer: its design, its stages, their solver's steps, its end.
class RunDisplay {
 public:
  /// Keeps references.
  RunDisplay(const Device& device, SnapshotBoard& board) : device_(device), board_(board) {}

  void showBegin(const std::string& status);
  /// The scene that is about to be designed, and its knobs: they can be turned while it is.
  void showScene(const Scene& scene);
  /// The target, and what the design says.
  void showDesign(const Scene& scene, const SceneDesign& designed);
  /// The first of a run is the one in the plane.
  void showStage(const Stage& stage);
  /// A coarser grid that is solved first; null: the stage's own.
  void showGrid(const std::shared_ptr<const DeviceGrid>& coarse);
  /// For methods that keep the positions on the host: 3 x vertexCount.
  void showPositions(const Eigen::Matrix3Xd& positions) { onDevice_->uploadPositions(positions); }
  void showSample(const ConvergenceSample& sample);
  void showPaused();
  /// The solver's grid is about to leave for inverse design's check from flat: the chosen design
  /// stays to be seen, where it has come to rest.
  void showCheckFromFlat(const StrutGrid& chosen);
  void showEnd(const Simulation& simulation);
  /// A finished run, all of it at once.
  void showStored(const RestoredRun& run);
  void showFailure(const std::string& problem);

 private:
  std::optional<ShownGrid> makeTarget(const GridShape& shape, const SceneDesign& designed);
  ShownGrid placed(const StrutGrid& grid, const Eigen::Matrix3Xd& positions,
                   const JointRotations& rotations = {});
  ShownGrid withNewestPositions(ShownGrid shown) const;
  std::string describeDistance(const ShownGrid& shown, const Snapshot& snapshot) const;

  const Device& device_;
  SnapshotBoard& board_;
  double meanLength_ = 0;                 ///< Of the last design's lateral struts; 0: none yet.
  std::optional<double> mmPerUnit_;       ///< Of the last design, see SceneDesign.
  int stages_ = 0;                        ///< Stages of this run so far.
  ShownGrid live_;                        ///< What is solved.
  std::shared_ptr<DeviceGrid> onDevice_;  ///< The same.
  /// Where the middle layer should lie, 3 x layerVertexCount of referenceShape_.
  std::shared_ptr<const Eigen::Matrix3Xd> reference_;
  GridShape referenceShape_{};
};

}  // namespace morphgrid
