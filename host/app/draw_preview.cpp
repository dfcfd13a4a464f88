#include "app/draw_preview.h"

#include <fmt/format.h>

#include "render/draw_sampling.h"
#include "render/sheet.h"
#include "surface/main_extent.h"

namespace morphgrid {
namespace {

constexpr int kPreviewRays = 31;  // Along either side of a box.
constexpr std::size_t kMostSides = 6;
constexpr double kMargin = 0.02;  // Around the mesh, in its sizes.

/// The corners of what is to be seen.
Camera cameraOn(const Eigen::AlignedBox3d& extent, double aspect) {
  Eigen::Matrix3Xd corners(3, 8);
  const Eigen::Vector3d margin = kMargin * extent.sizes();
  const Eigen::AlignedBox3d seen(extent.min() - margin, extent.max() + margin);
  for (int n = 0; n < 8; ++n) {
    corners.col(n) = seen.corner(static_cast<Eigen::AlignedBox3d::CornerType>(n));
  }
  return frameAll(corners, kRayView.direction, kRayView.up, aspect);
}

Image drawSide(const Device& device, const TriangleMesh& mesh, const PreviewSide& side,
               const SceneSize& size) {
  const TriangleMesh turned = transformed(Eigen::Affine3d(side.sight.rotation()), mesh);
  const Eigen::AlignedBox3d extent = mainExtent(turned);
  const Eigen::Vector3d sizes = extent.sizes();
  const double least = 1e-3 * sizes.maxCoeff();  // A plate is seen edge-on, too.
  const SamplingBox all{extent.min().y(), extent.min().z(), std::max(sizes.y(), least),
                        std::max(sizes.z(), least)};
  const RayHits hits =
      MeshRayCaster(turned).cast(side.box.value_or(all), kPreviewRays, kPreviewRays);
  return drawSampling(device, turned, hits, cameraOn(extent, size.aspect()), size.width,
                      size.height);
}

}  // namespace

void drawPreview(const std::filesystem::path& file, const std::string& title,
                 const TriangleMesh& mesh, const std::vector<PreviewSide>& sides,
                 const DeviceOptions& options) {
  const Device device(options);
  const SheetOptions sheet{.title = title, .panelWidth = 480, .panelHeight = 400};
  const SceneSize size = sceneSize(panelPicture(sheet));
  std::vector<Panel> panels;
  for (const PreviewSide& side : sides) {
    panels.push_back({drawSide(device, mesh, side, size), side.caption, {}});
  }
  writePng(file, composeSheet(panels, sheet));
}

std::vector<PreviewSide> previewSides(const std::vector<SightRating>& sights) {
  std::vector<PreviewSide> sides;
  for (const SightRating& rating : sights) {
    if (sides.size() == kMostSides) break;
    sides.push_back({rating.sight, rating.box,
                     rating.box ? fmt::format("{}: a box without holes has {:.0f} % of the surface",
                                              rating.sight.name, 100 * rating.share)
                                : fmt::format("{}: no box without holes", rating.sight.name)});
  }
  return sides;
}

}  // namespace morphgrid
