#pragma once
#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grid/joint_rotations.h"
#include "grid/shrink.h"
#include "render/camera.h"
#include "solve/device_grid.h"
#include "solve/equilibrium.h"
#include "surface/mesh_sampling.h"

namespace morphgrid {

/// What of a run can be looked at, in the order in which it comes to be.
enum class ShownStage { target, sampling, initial, inPlane, stacked, warped, surface };
constexpr std::array<const char*, 7> kStageNames = {"target",  "sampling", "initial", "in-plane",
                                                    "stacked", "warped",   "surface"};

/// A grid to draw, from the solver's own buffers.
struct ShownGrid {
  std::shared_ptr<const DeviceGrid> onDevice;
  Eigen::Isometry3d worldFromGrid = Eigen::Isometry3d::Identity();  ///< To where the target lies.
  std::shared_ptr<const StrutGrid> grid;              ///< Null for the solver's coarser grids.
  std::shared_ptr<const Eigen::Matrix3Xd> positions;  ///< 3 x vertexCount, of a while ago.
  std::shared_ptr<const JointRotations> rotations;    ///< Of a frame's joints, of then; else null.
};

enum class Activity {
  designing,
  solving,
  paused,
  atRest,
  failed,  ///< See Snapshot::problem.
};

/// A setting of the scene that the user can turn, as the scene file calls it.
struct Knob {
  std::string key;    ///< Dotted, e.g. "grid.layers".
  std::string label;  ///< For people.
  double value = 0;   ///< For a choice, its index.
  double low = 0;     ///< Of an integer, the least that the scene file may hold ...
  double high = 1;    ///< ... and the most.
  bool isInteger = false;
  bool isBoolean = false;  ///< 0 or 1.
  bool isLogarithmic = false;
  std::vector<std::string> choices;  ///< Not empty: one of these.
};

/// What there is to see at a moment. It does not change; a new one takes its place.
struct Snapshot {
  bool has(ShownStage stage) const {
    return stage == ShownStage::sampling ? sampling != nullptr
                                         : stages[static_cast<std::size_t>(stage)].has_value();
  }

  std::string title;
  std::string status;  ///< What is being done, or how it ended.
  Activity activity = Activity::designing;
  std::array<std::optional<ShownGrid>, kStageNames.size()>
      stages;                                       ///< Without sampling, which has no grid.
  std::shared_ptr<const MeshSampling> sampling;     ///< None but for meshes.
  ShownStage newest = ShownStage::target;           ///< The stage that the run has reached.
  std::shared_ptr<const Eigen::Matrix3Xd> targets;  ///< 3 x layerVertexCount; null without target.
  /// layerVertexCount, rad: at each joint the largest printed angle less what the target wants;
  /// null without a conformal sheet.
  std::shared_ptr<const Eigen::VectorXd> angleErrors;
  Eigen::AlignedBox3d extent;  ///< Bounding box of all that is shown; may be empty.
  View view = kPatchView;      ///< To begin with.
  ShrinkBounds shrinkBounds;   ///< What struts can lose, in the unit of the grids.
  std::vector<Knob> knobs;
  std::vector<ConvergenceSample> history;  ///< Samples of the stage that is solved, or was last.
  std::string figures;                     ///< The report's table.
  std::vector<std::string> notices;
  std::optional<std::string> problem;
  std::string message;  ///< What the last command wrote where.
  bool canUndo = false;
  bool canRedo = false;
  bool isOutdated = false;  ///< A file that the scene is read from has changed on disk.
  long runs = 0;            ///< Counts the designs.
  int strutCount = 0;       ///< Struts of the designed grid.
};

/// A scene that is designed and solved on a thread of its own while a window looks on. All
/// functions return at once.
class Session {
 public:
  virtual ~Session() = default;

  virtual std::shared_ptr<const Snapshot> snapshot() const = 0;

  /// A frame has been shown: the solver may do its next step.
  virtual void noteFrame() = 0;

  virtual void pause(bool isPaused) = 0;
  virtual void step() = 0;
  virtual void showEveryStep(bool isShown) = 0;
  /// Designs and solves anew, from flat.
  virtual void restart() = 0;
  /// value: as in the scene file.
  virtual void turnKnob(const std::string& key, const std::string& value) = 0;
  virtual void undo() = 0;
  virtual void redo() = 0;
  virtual void reload() = 0;
  virtual void saveScene() = 0;
  virtual void exportFiles() = 0;
};

}  // namespace morphgrid
