#include "app/pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "grid/shrink.h"
#include "render/draw_sampling.h"
#include "render/font.h"
#include "render/sampling_layout.h"
#include "render/spread_layers.h"

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

StrutValues dividedBy(StrutValues values, double divisor) {
  for (std::vector<double>* direction : {&values.u, &values.v, &values.w}) {
    for (double& value : *direction) {
      value /= divisor;
    }
  }
  return values;
}

PictureOptions optionsFor(const PictureChoices& choices) {
  return {.width = choices.width, .height = choices.height, .caption = {}, .legend = {}};
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
                     std::optional<Legend> legend) const {
  PictureOptions options = options_;
  options.caption = caption;
  options.legend = std::move(legend);
  writePng(folder_ / (name + ".png"), composePicture(scene, options));
}

void Pictures::drawSampling(const TriangleMesh& mesh, const RayHits& hits) const {
  const SceneSize size = sceneSize(options_);
  const bool missed = std::find(hits.hit.begin(), hits.hit.end(), 0) != hits.hit.end();
  const Camera camera = frameRays(mesh, hits, size.aspect());
  write("sampling",
        fmt::format("sampling: rays, u splines red, v splines blue{}",
                    missed ? ", missed rays orange" : ""),
        morphgrid::drawSampling(device_, mesh, hits, camera, size.width, size.height));
}

void Pictures::drawFlat(const std::string& name, const std::string& caption,
                        const DeviceGrid& deviceGrid, const Eigen::Matrix3Xd& positions) {
  const auto inPlace = Eigen::Isometry3d::Identity();
  write(name, caption, renderer_.drawStruts(deviceGrid, inPlace, frame(positions, kPatchView)),
        strainLegend());
}

void Pictures::drawShrink(const StrutGrid& stacked, double maxShrinkage) const {
  const SceneSize size = sceneSize(options_);
  const StrutGrid layers = spreadLayers(stacked, size.aspect());
  const DeviceGrid deviceGrid(device_, layers);
  write("shrink",
        fmt::format("shrink: layers side by side, bottom first; 100 % is the allowed {:g} %",
                    100 * maxShrinkage),
        drawStrutShares(device_, deviceGrid, dividedBy(computeShrinks(stacked), maxShrinkage),
                        frame(layers.positions, kTopView), size.width, size.height),
        shrinkLegend());
}

void Pictures::drawDistance(const PlacedGrid& result, const DeviceGrid& target,
                            const Eigen::Matrix3Xd& alignedMiddle, const Eigen::Matrix3Xd& targets,
                            const Camera& camera) const {
  const Eigen::VectorXd distances = (alignedMiddle - targets).colwise().norm();
  const double largest = distances.maxCoeff();
  const double diagonal = (targets.rowwise().maxCoeff() - targets.rowwise().minCoeff()).norm();
  const SceneSize size = sceneSize(options_);
  write("distance", "distance to the overlaid target: % of its diagonal, and length",
        drawSurfaceShares(device_, result, distances / (largest > 0 ? largest : 1),
                          {target, Eigen::Isometry3d::Identity()}, camera, size.width, size.height),
        distanceLegend(largest, 100 * largest / diagonal));
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
        renderer_.drawStruts(deviceGrid, targetFromGrid, camera), strainLegend());
  write("surface", "surface: the middle layer",
        renderer_.drawSurface(deviceGrid, targetFromGrid, camera));
  if (targets) {
    const StrutGrid grid = targetGrid(deviceGrid.shape(), deviceGrid.spacing(), *targets);
    const DeviceGrid target(device_, grid);
    write("target", "target", renderer_.drawSurface(target, Eigen::Isometry3d::Identity(), camera));
    drawDistance({deviceGrid, targetFromGrid}, target, middleLayer(deviceGrid.shape(), aligned),
                 *targets, camera);
  }
}

}  // namespace morphgrid
