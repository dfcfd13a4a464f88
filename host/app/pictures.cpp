#include "app/pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "grid/strut_grid.h"
#include "render/draw_sampling.h"
#include "render/font.h"
#include "render/sampling_layout.h"

namespace morphgrid {
namespace {

/// The target as a grid of one layer at rest, so that it is drawn by the same pipeline as the
/// result.
StrutGrid targetGrid(const GridShape& shape, double spacing, const Eigen::Matrix3Xd& targets) {
  const GridShape layer{shape.verticesU, shape.verticesV, 1};
  StrutGrid grid{layer, spacing, targets, StrutValues(layer), StrutValues(layer), 1.0};
  for (const Strut& strut : listStruts(layer)) {
    valueAt(grid.rest, strut) = (targets.col(strut.to) - targets.col(strut.from)).norm();
    valueAt(grid.stiffness, strut) = 1;
  }
  return grid;
}

PictureOptions optionsFor(const PictureChoices& choices) {
  return {.width = choices.width, .height = choices.height, .caption = {}, .legend = true};
}

}  // namespace

Pictures::Pictures(const Device& device, const PictureChoices& choices,
                   std::filesystem::path folder, View resultView)
    : device_(device),
      options_(optionsFor(choices)),
      folder_(std::move(folder)),
      resultView_(std::move(resultView)),
      renderer_(device, sceneSize(options_).width, sceneSize(options_).height) {
  Font::findSans();  // A missing font is told before the solve, not after it.
}

Camera Pictures::frame(const Eigen::Matrix3Xd& points, const View& view) const {
  return frameAll(points, view.direction, view.up, sceneSize(options_).aspect());
}

void Pictures::write(const std::string& name, const std::string& caption, const Image& scene,
                     bool legend) const {
  PictureOptions options = options_;
  options.caption = caption;
  options.legend = legend;
  writePng(folder_ / (name + ".png"), composePicture(scene, options));
}

void Pictures::drawSampling(const TriangleMesh& mesh, const RayHits& hits) const {
  const SceneSize size = sceneSize(options_);
  const bool missed = std::find(hits.hit.begin(), hits.hit.end(), 0) != hits.hit.end();
  const Camera camera = frameRays(mesh, hits, size.aspect());
  write("sampling",
        fmt::format("sampling: rays, u splines red, v splines blue{}",
                    missed ? ", missed rays orange" : ""),
        morphgrid::drawSampling(device_, mesh, hits, camera, size.width, size.height), false);
}

void Pictures::drawFlat(const std::string& name, const std::string& caption,
                        const DeviceGrid& deviceGrid, const Eigen::Matrix3Xd& positions) {
  const auto inPlace = Eigen::Isometry3d::Identity();
  write(name, caption, renderer_.drawStruts(deviceGrid, inPlace, frame(positions, kPatchView)),
        true);
}

void Pictures::drawResult(const DeviceGrid& deviceGrid, const Eigen::Matrix3Xd& positions,
                          const Eigen::Isometry3d& targetFromGrid,
                          const std::optional<Eigen::Matrix3Xd>& targets) {
  const Eigen::Matrix3Xd aligned = targetFromGrid * positions;
  Eigen::Matrix3Xd seen(3, aligned.cols() + (targets ? targets->cols() : 0));
  seen.leftCols(aligned.cols()) = aligned;
  if (targets) {
    seen.rightCols(targets->cols()) = *targets;
  }
  const Camera camera = frame(seen, resultView_);
  write("warped", "warped: struts by strain",
        renderer_.drawStruts(deviceGrid, targetFromGrid, camera), true);
  write("surface", "surface: the middle layer",
        renderer_.drawSurface(deviceGrid, targetFromGrid, camera), false);
  if (targets) {
    const StrutGrid grid = targetGrid(deviceGrid.shape(), deviceGrid.spacing(), *targets);
    const DeviceGrid target(device_, grid);
    write("target", "target", renderer_.drawSurface(target, Eigen::Isometry3d::Identity(), camera),
          false);
  }
}

}  // namespace morphgrid
