#include "benchmark/fidelity_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/bounding_diagonal.h"
#include "grid/strut_grid.h"
#include "render/sheet.h"
#include "render/strain_renderer.h"

namespace morphgrid {
namespace {

const auto kInPlace = Eigen::Isometry3d::Identity();

/// Both designs and both targets.
Eigen::Matrix3Xd allPoints(const FidelityTrio& trio) {
  const auto count =
      trio.papers.middle.cols() + trio.springs.middle.cols() + trio.ours.middle.cols();
  Eigen::Matrix3Xd points(3, 2 * count);
  points << trio.papers.middle, trio.papers.targets, trio.springs.middle, trio.springs.targets,
      trio.ours.middle, trio.ours.targets;
  return points;
}

/// Draws the panels of a sheet.
class FidelityPanels {
 public:
  FidelityPanels(const Device& device, const FidelityTrio& trio, SceneSize size)
      : device_(device),
        renderer_(device, size.width, size.height),
        camera_(
            frameAll(allPoints(trio), trio.ours.view.direction, trio.ours.view.up, size.aspect())),
        largestPercent_(
            std::max({trio.papers.frame.asDesigned.max, trio.springs.frame.asDesigned.max,
                      trio.ours.frame.asDesigned.max})) {}

  Panel target(const FidelityRun& run) {
    const DeviceGrid grid(device_, layerOf(run, run.targets));
    return {renderer_.drawSurface(grid, kInPlace, camera_), "target", {}};
  }

  Panel design(const char* whose, const FidelityRun& run) {
    const DeviceGrid grid(device_, layerOf(run, run.middle));
    const DeviceGrid target(device_, layerOf(run, run.targets));
    const double largest = largestPercent_ / 100 * boundingDiagonal(run.targets);
    const Eigen::VectorXd distances = (run.middle - run.targets).colwise().norm();
    return {renderer_.drawSurfaceShares({grid, kInPlace}, distances / largest, {target, kInPlace},
                                        camera_),
            fmt::format("{}: RMS {:.2g}, max {:.2g} %", whose, run.frame.asDesigned.rms,
                        run.frame.asDesigned.max),
            distanceLegend(largest, largestPercent_)};
  }

 private:
  static StrutGrid layerOf(const FidelityRun& run, const Eigen::Matrix3Xd& points) {
    return layerAtRest(run.record.grid.shape, run.record.grid.spacing, points);
  }

  const Device& device_;
  StrainRenderer renderer_;
  Camera camera_;
  double largestPercent_;  ///< Where the colours end.
};

}  // namespace

Image drawFidelity(const Device& device, const FidelityTrio& trio) {
  const SheetOptions options{
      .title = trio.papers.record.title, .columns = 2, .panelWidth = 440, .panelHeight = 360};
  FidelityPanels panels(device, trio, sceneSize(panelPicture(options)));
  return composeSheet({panels.target(trio.ours), panels.design("paper's", trio.papers),
                       panels.design("springs'", trio.springs), panels.design("ours", trio.ours)},
                      options);
}

}  // namespace morphgrid
