#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "app/scene.h"
#include "render/picture.h"
#include "render/strain_renderer.h"
#include "surface/mesh_ray_caster.h"

namespace morphgrid {

/// Draws the panels of a run into its folder, from the solver's buffers.
class Pictures {
 public:
  /// resultView: where drawResult() looks from.
  Pictures(const Device& device, const PictureChoices& choices, std::filesystem::path folder,
           View resultView = kPatchView);

  /// How rays sampled a mesh (sampling.png).
  void drawSampling(const TriangleMesh& mesh, const RayHits& hits) const;

  /// A flat stage in its own frame. positions: what the device grid holds, to frame it by.
  void drawFlat(const std::string& name, const std::string& caption, const DeviceGrid& deviceGrid,
                const Eigen::Matrix3Xd& positions);

  /// The morphed struts (warped.png), the surface of the middle layer (surface.png) and the target
  /// (target.png, where there is one), all seen by the same camera.
  void drawResult(const DeviceGrid& deviceGrid, const Eigen::Matrix3Xd& positions,
                  const Eigen::Isometry3d& targetFromGrid,
                  const std::optional<Eigen::Matrix3Xd>& targets);

 private:
  Camera frame(const Eigen::Matrix3Xd& points, const View& view) const;
  void write(const std::string& name, const std::string& caption, const Image& scene,
             bool legend) const;

  const Device& device_;
  PictureOptions options_;
  std::filesystem::path folder_;
  View resultView_;
  StrainRenderer renderer_;
};

}  // namespace morphgrid
