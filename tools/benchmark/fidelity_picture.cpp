#include "benchmark/fidelity_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/bounding_diagonal.h"
#include "grid/strut_grid.h"
#include "render/draw_shares.h"
#include "render/sheet.h"
#include "render/strain_renderer.h"

namespace morphgrid {
namespace {

const auto kInPlace = Eigen::Isometry3d::Identity();

/// Both designs and both targets.
Eigen::Matrix3Xd allPoints(const FidelityPair& pair) {
  Eigen::Matrix3Xd points(3, 2 * (pair.papers.middle.cols() + pair.ours.middle.cols()));
  points << pair.papers.middle, pair.papers.targets, pair.ours.middle, pair.ours.targets;
  return points;
}

/// Draws the panels of a sheet.
class FidelityPanels {
 public:
  FidelityPanels(const Device& device, const FidelityPair& pair, SceneSize size)
      : device_(device),
        size_(size),
        camera_(
            frameAll(allPoints(pair), pair.ours.view.direction, pair.ours.view.up, size.aspect())),
        largestPercent_(std::max(pair.papers.record.distance->maxPercent,
                                 pair.ours.record.distance->maxPercent)) {}

  Panel target(const FidelityRun& run) const {
    const DeviceGrid grid(device_, layerOf(run, run.targets));
    StrainRenderer renderer(device_, size_.width, size_.height);
    return {renderer.drawSurface(grid, kInPlace, camera_), "target", {}};
  }

  Panel design(const char* whose, const FidelityRun& run) const {
    const DeviceGrid grid(device_, layerOf(run, run.middle));
    const DeviceGrid target(device_, layerOf(run, run.targets));
    const double largest = largestPercent_ / 100 * boundingDiagonal(run.targets);
    const Eigen::VectorXd distances = (run.middle - run.targets).colwise().norm();
    return {drawSurfaceShares(device_, {grid, kInPlace}, distances / largest, {target, kInPlace},
                              camera_, size_.width, size_.height),
            fmt::format("{}: RMS {:.2g}, max {:.2g} %", whose, run.record.distance->rmsPercent,
                        run.record.distance->maxPercent),
            distanceLegend(largest, largestPercent_)};
  }

 private:
  static StrutGrid layerOf(const FidelityRun& run, const Eigen::Matrix3Xd& points) {
    return layerAtRest(run.record.grid.shape, run.record.grid.spacing, points);
  }

  const Device& device_;
  SceneSize size_;
  Camera camera_;
  double largestPercent_;  ///< Where the colours end.
};

}  // namespace

Image drawFidelity(const Device& device, const FidelityPair& pair) {
  const SheetOptions options{
      .title = pair.papers.record.title, .panelWidth = 440, .panelHeight = 360};
  const FidelityPanels panels(device, pair, sceneSize(panelPicture(options)));
  return composeSheet({panels.target(pair.ours), panels.design("paper's", pair.papers),
                       panels.design("ours", pair.ours)},
                      options);
}

}  // namespace morphgrid
