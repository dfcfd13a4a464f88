#pragma once
#include <functional>
#include <optional>
#include <string>

#include "grid/shrink.h"
#include "render/sheet.h"
#include "render/strain_renderer.h"
#include "render/thinned_lattice.h"
#include "surface/mesh_ray_caster.h"

namespace morphgrid {

/// What becomes of a drawn panel; its name is that of a file without an extension.
using ShowPanel = std::function<void(const std::string& name, const Panel& panel)>;

/// Draws the panels of a run, from the solver's buffers, with scale bars.
class Pictures {
 public:
  /// picture: its size. resultView: where drawResult() looks from.
  Pictures(const Device& device, const PictureOptions& picture, ShowPanel show,
           View resultView = kPatchView);

  /// From now on lengths are told in it; before in the scene's.
  void tellLengthsIn(const LengthUnit& unit) { unit_ = unit; }

  /// What they show of a grid: cells a few pixels wide, as seen from above; a frame's bars all.
  ThinnedLattice latticeFor(const StrutGrid& grid) const;

  /// How rays sampled a mesh (sampling).
  void drawSampling(const TriangleMesh& mesh, const RayHits& hits) const;

  /// Flat stages in their own frames: before the stage in the plane (initial), after it (in_plane)
  /// and before the morph (stacked). positions: what the device grid holds, to frame it by.
  void drawInitial(const DeviceGrid& deviceGrid, const Eigen::Matrix3Xd& positions);
  void drawInPlane(const DeviceGrid& deviceGrid, const Eigen::Matrix3Xd& positions);
  void drawStacked(const DeviceGrid& deviceGrid, const Eigen::Matrix3Xd& positions);

  /// The lateral struts of the printed layers, drawn apart, by how much of what they can shrink
  /// they use (shrink).
  void drawShrink(const StrutGrid& stacked, const ShrinkBounds& bounds);

  /// The morphed struts (warped), the surface of the middle layer (surface) and, where there is a
  /// target, that (target) and the distance to it (distance), all seen by the same camera.
  void drawResult(const DeviceGrid& deviceGrid, const Eigen::Matrix3Xd& positions,
                  const Eigen::Isometry3d& targetFromGrid,
                  const std::optional<Eigen::Matrix3Xd>& targets);

 private:
  void drawFlat(const std::string& name, const std::string& caption, const DeviceGrid& deviceGrid,
                const Eigen::Matrix3Xd& positions);
  std::optional<ScaleBar> scaleBar(const Camera& camera, const Eigen::Matrix3Xd& seen) const;
  Camera frame(const Eigen::Matrix3Xd& points, const View& view) const;
  void drawDistance(const PlacedGrid& result, const DeviceGrid& target,
                    const Eigen::Matrix3Xd& alignedMiddle, const Eigen::Matrix3Xd& targets,
                    const Camera& camera);

  const Device& device_;
  SceneSize size_;
  ShowPanel show_;
  View resultView_;
  StrainRenderer renderer_;
  LengthUnit unit_{.perSceneUnit = 1, .name = "units", .nameOfOne = "unit"};
};

}  // namespace morphgrid
