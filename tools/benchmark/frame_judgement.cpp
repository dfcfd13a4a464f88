#include "benchmark/frame_judgement.h"

#include <random>

#include "inverse/shape_error.h"
#include "solve/morph_course.h"

namespace morphgrid {
namespace {

constexpr int kLoadSteps = 10;
constexpr double kInexactness = 0.02;
constexpr double kThicker = 1.25;

/// The positions where it comes to rest.
Eigen::Matrix3Xd morph(const Device& device, StrutGrid grid, const MaterialRequest& bars) {
  applyMaterial(grid, bars);
  MultigridSolver solver(device, grid);
  return followMorph(solver, {.steps = kLoadSteps}).end.positions;
}

StrutGrid madeInexactly(StrutGrid grid) {
  std::mt19937 random(1);
  std::normal_distribution<double> share(1, kInexactness);
  forEachLateralStrut(grid.shape,
                      [&](const Strut& strut) { valueAt(grid.rest, strut) *= share(random); });
  return grid;
}

}  // namespace

FrameJudgement judgeAsFrame(const Device& device, const StrutGrid& grid,
                            const Eigen::Matrix3Xd& targets, MaterialRequest bars) {
  bars.model = Model::frame;
  double sum = 0;
  forEachLateralStrut(grid.shape, [&](const Strut& strut) { sum += valueAt(grid.rest, strut); });
  const BarSizes sizes = barSizesOf(bars, sum / grid.shape.lateralStrutCount());
  bars.barWidth = sizes.width;
  bars.barHeight = sizes.height;
  bars.postWidth = sizes.post;
  const auto distanceAt = [&](const Eigen::Matrix3Xd& positions) -> ShapePercent {
    const ShapeError error = computeShapeError(grid.shape, positions, targets);
    return {error.rmsPercent, error.maxPercent};
  };
  const Eigen::Matrix3Xd end = morph(device, grid, bars);
  FrameJudgement judgement{.asDesigned = distanceAt(end), .middle = middleLayer(grid.shape, end)};
  judgement.inexact = distanceAt(morph(device, madeInexactly(grid), bars));
  for (auto* size : {&bars.barWidth, &bars.barHeight, &bars.postWidth}) {
    *size = **size * kThicker;
  }
  judgement.thicker = distanceAt(morph(device, grid, bars));
  return judgement;
}

}  // namespace morphgrid
