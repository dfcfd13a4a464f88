#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "app/scene.h"
#include "render/draw_shares.h"
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

  /// The lateral struts of the printed layers, drawn apart, by how much of what they can shrink
  /// they use (shrink.png).
  void drawShrink(const StrutGrid& stacked, double maxShrinkage) const;

  /// The morphed struts (warped.png), the surface of the middle layer (surface.png) and, where
  /// there is a target, that (target.png) and the distance to it (distance.png), all seen by the
  /// same camera.
  void drawResult(const DeviceGrid& deviceGrid, const Eigen::Matrix3Xd& positions,
                  const Eigen::Isometry3d& targetFromGrid,
                  const std::optional<Eigen::Matrix3Xd>& targets);

 private:
  Camera frame(const Eigen::Matrix3Xd& points, const View& view) const;
  void write(const std::string& name, const std::string& caption, const Image& scene,
             std::optional<Legend> legend = std::nullopt) const;
  void drawDistance(const PlacedGrid& result, const DeviceGrid& target,
                    const Eigen::Matrix3Xd& alignedMiddle, const Eigen::Matrix3Xd& targets,
                    const Camera& camera) const;

  const Device& device_;
  PictureOptions options_;
  std::filesystem::path folder_;
  View resultView_;
  StrainRenderer renderer_;
};

}  // namespace morphgrid
