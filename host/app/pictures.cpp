#include "app/pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/intrinsic_diagonal.h"
#include "grid/shrink.h"
#include "grid/strut_grid.h"
#include "render/draw_sampling.h"
#include "render/font.h"
#include "render/sampling_layout.h"
#include "render/spread_layers.h"

namespace morphgrid {
namespace {

constexpr int kFewestPixelsPerCell = 4;
constexpr double kScaleBarShare = 0.2;  // Of a picture's width, at most.

}  // namespace

Pictures::Pictures(const Device& device, const PictureOptions& picture, ShowPanel show,
                   View resultView)
    : device_(device),
      size_(sceneSize(picture)),
      show_(std::move(show)),
      resultView_(std::move(resultView)),
      renderer_(device, size_.width, size_.height) {
  Font::findSans();  // A missing font is reported before the solve, not after it.
}

std::optional<ScaleBar> Pictures::scaleBar(const Camera& camera,
                                           const Eigen::Matrix3Xd& seen) const {
  const Eigen::Vector3d middle = (seen.rowwise().maxCoeff() + seen.rowwise().minCoeff()) / 2;
  return scaleBarAt(camera, middle, size_.height, kScaleBarShare * size_.width, unit_);
}

Camera Pictures::frame(const Eigen::Matrix3Xd& points, const View& view) const {
  return frameAll(points, view.direction, view.up, size_.aspect());
}

ThinnedLattice Pictures::latticeFor(const StrutGrid& grid) const {
  const int cells = std::max(grid.shape.cellsU(), grid.shape.cellsV());
  return {grid.shape, grid.bars ? cells : size_.width / kFewestPixelsPerCell};
}

void Pictures::drawSampling(const TriangleMesh& mesh, const RayHits& hits) const {
  const bool missed = std::find(hits.hit.begin(), hits.hit.end(), 0) != hits.hit.end();
  const Camera camera = frameRays(mesh, hits, size_.aspect());
  show_("sampling",
        {morphgrid::drawSampling(device_, mesh, hits, camera, size_.width, size_.height),
         fmt::format("sampling: rays, u splines red, v splines blue{}",
                     missed ? ", missed rays orange" : ""),
         {}});
}

void Pictures::drawFlat(const std::string& name, const std::string& caption,
                        const DeviceGrid& deviceGrid, const Eigen::Matrix3Xd& positions) {
  const Camera camera = frame(positions, kPatchView);
  const Eigen::Vector2d size =
      unit_.perSceneUnit *
      (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).head<2>();
  show_(name, {renderer_.drawStruts(deviceGrid, Eigen::Isometry3d::Identity(), camera),
               fmt::format("{}, {:.4g} x {}", caption, size.x(), unit_.text(size.y())),
               strainLegend(), scaleBar(camera, positions)});
}

void Pictures::drawInitial(const DeviceGrid& deviceGrid, const Eigen::Matrix3Xd& positions) {
  drawFlat("initial", "initial: one layer of square cells", deviceGrid, positions);
}

void Pictures::drawInPlane(const DeviceGrid& deviceGrid, const Eigen::Matrix3Xd& positions) {
  drawFlat("in_plane", "in plane: the layer to be printed", deviceGrid, positions);
}

void Pictures::drawStacked(const DeviceGrid& deviceGrid, const Eigen::Matrix3Xd& positions) {
  drawFlat("stacked", "stacked: all layers, before the morph", deviceGrid, positions);
}

void Pictures::drawShrink(const StrutGrid& stacked, const ShrinkBounds& bounds) {
  const ThinnedLattice lattice = latticeFor(stacked);
  const StrutValues shares = computeShrinkShares(stacked, bounds);
  const StrutGrid layers = spreadLayers(
      lattice.isWhole() ? stacked : lattice.grid(stacked, stacked.positions), size_.aspect());
  const DeviceGrid deviceGrid(device_, layers);
  const Camera camera = frame(layers.positions, kTopView);
  show_("shrink",
        {renderer_.drawStrutShares(deviceGrid, computeShrinkShares(stacked, bounds), camera),
         fmt::format("shrink: layers side by side, bottom first; 100 % is {}",
                     bounds.hubDiameter > 0
                         ? std::string("what each strut can")
                         : fmt::format("the allowed {:g} %", 100 * bounds.material.most)),
         shrinkLegend(), scaleBar(camera, layers.positions)});
}

void Pictures::drawDistance(const PlacedGrid& result, const DeviceGrid& target,
                            const Eigen::Matrix3Xd& alignedMiddle, const Eigen::Matrix3Xd& targets,
                            const Camera& camera) {
  const Eigen::VectorXd distances = (alignedMiddle - targets).colwise().norm();
  const double largest = distances.maxCoeff();
  const double diagonal = intrinsicDiagonal(targets);
  show_("distance", {renderer_.drawSurfaceShares(result, distances / (largest > 0 ? largest : 1),
                                                 {target, Eigen::Isometry3d::Identity()}, camera),
                     "distance to the overlaid target: % of its diagonal, and length",
                     distanceLegend(largest, 100 * largest / diagonal), scaleBar(camera, targets)});
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
  const std::optional<ScaleBar> bar = scaleBar(camera, seen);
  show_("warped", {renderer_.drawStruts(deviceGrid, targetFromGrid, camera),
                   "warped: struts by strain", strainLegend(), bar});
  show_("surface", {renderer_.drawSurface(deviceGrid, targetFromGrid, camera),
                    "surface: the middle layer",
                    {},
                    bar});
  if (targets) {
    const StrutGrid grid = layerAtRest(deviceGrid.shape(), deviceGrid.spacing(), *targets);
    const DeviceGrid target(device_, grid);
    show_(
        "target",
        {renderer_.drawSurface(target, Eigen::Isometry3d::Identity(), camera), "target", {}, bar});
    drawDistance({deviceGrid, targetFromGrid}, target, middleLayer(deviceGrid.shape(), aligned),
                 *targets, camera);
  }
}

}  // namespace morphgrid
