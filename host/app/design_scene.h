#pragma once
#include <functional>

#include "app/load_target.h"
#include "layout/sheet_figures.h"

namespace morphgrid {

/// A net laid out flat.
struct LaidSheet {
  Sheet sheet;
  SheetFigures figures;
};

/// The inverse design of a scene, and what was measured for it.
struct SceneDesign {
  std::shared_ptr<const Target> target;  ///< None for grids given by bend angles.
  GridDesign design;
  std::optional<MeasurementFigures> measurement;  ///< None without a target.
  std::optional<NetFigures> net;                  ///< None without a target.
  /// 3 x layerVertexCount: where the middle layer's vertices should lie.
  std::optional<Eigen::Matrix3Xd> targets;
  Eigen::Matrix3Xd normals;  ///< Of the target there; only of Reference::middle.
  LayerStack stack{};
  std::optional<LaidSheet> sheet;    ///< Only of Layout::conformal.
  std::optional<MeshFigures> mesh;   ///< Only of meshes.
  std::vector<std::string> notices;  ///< What was clamped or overridden.
  View ownView = kPatchView;         ///< Where there is no target to say it.
  /// layerVertexCount, rad, of Layout::conformal: see printedAngleErrors(); else empty.
  Eigen::VectorXd angleErrors{};
  /// At which the grid is printed; with [print], and where the scene says it or the sheet is laid
  /// out. Else the sheet that the stage in the plane leaves tells.
  std::optional<double> mmPerUnit{};

  /// From where the morphed grid is seen best.
  View view() const { return target ? target->view() : ownView; }
};

/// Throws InputError where there is no room for such a grid.
using RequireShape = std::function<void(const GridShape&)>;

/// Measures the scene's target, see loadTarget(), and designs the grid. requireShape: asked before
/// anything is measured that grows with the grid; may be empty. Throws InputError when they cannot
/// be had, Cancelled when scene.solve is requested to stop.
SceneDesign designScene(const Scene& scene, const std::shared_ptr<const Target>& target,
                        const RequireShape& requireShape = {});
/// Loads the target, too.
SceneDesign designScene(const Scene& scene, const RequireShape& requireShape = {});

/// Keeps the last design while what it comes from stays.
class DesignKeeper {
 public:
  /// As designScene().
  std::shared_ptr<const SceneDesign> designOf(const Scene& scene,
                                              const std::shared_ptr<const Target>& target);

 private:
  SurfaceRequest surface_;
  DesignRequest request_;
  MaterialRequest material_;
  std::optional<ScenePrint> print_;
  std::shared_ptr<const SceneDesign> design_;
};

/// What there is to report before anything is solved.
RunRecord recordOf(const Scene& scene, const SceneDesign& designed);

}  // namespace morphgrid
