#include "app/pictures.h"

#include <fmt/format.h>

#include "grid/strut_grid.h"
#include "render/font.h"

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
                   std::filesystem::path folder)
    : device_(device),
      options_(optionsFor(choices)),
      folder_(std::move(folder)),
      renderer_(device, sceneSize(options_).width, sceneSize(options_).height) {
  Font::findSans();  // A missing font is told before the solve, not after it.
}

Camera Pictures::frame(const Eigen::Matrix3Xd& points) const {
  return frameAll(points, kObliqueViewDirection, kUpwards, sceneSize(options_).aspect());
}

void Pictures::write(const std::string& name, const std::string& caption, const Image& scene,
                     bool legend) const {
  PictureOptions options = options_;
  options.caption = caption;
  options.legend = legend;
  writePng(folder_ / (name + ".png"), composePicture(scene, options));
}

void Pictures::drawFlat(const std::string& name, const std::string& caption,
                        const DeviceGrid& deviceGrid, const Eigen::Matrix3Xd& positions) {
  const auto inPlace = Eigen::Isometry3d::Identity();
  write(name, caption, renderer_.drawStruts(deviceGrid, inPlace, frame(positions)), true);
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
  const Camera camera = frame(seen);
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
