#include "layout/sheet_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;

// Beyond the range by less is rounding.
constexpr double kTolerance = 1e-6;
constexpr double kFewOutliers = 0.01;

struct MeanAndLargest {
  double mean = 0;
  double largest = 0;
};

/// valueOf(SheetCorner), absolute, over all corners.
template <typename ValueOf>
MeanAndLargest overCorners(const std::vector<SheetCorner>& corners, const ValueOf& valueOf) {
  MeanAndLargest result;
  for (const SheetCorner& corner : corners) {
    const double value = std::abs(valueOf(corner));
    result.mean += value / static_cast<double>(corners.size());
    result.largest = std::max(result.largest, value);
  }
  return result;
}

/// Of a corner's bars as they leave its joint; directionOf(bar, at its `from` end).
template <typename DirectionOf>
double angleBetween(const SheetCorner& corner, const DirectionOf& directionOf) {
  const auto away = [&](int bar, bool leaves) {
    return directionOf(bar, leaves) + (leaves ? 0 : std::numbers::pi);
  };
  return away(corner.second, corner.leavesSecond) - away(corner.first, corner.leavesFirst);
}

int otherEnd(const SheetBar& bar, bool leaves) { return leaves ? bar.to : bar.from; }

double cornerAngle(const SheetCorner& corner, const std::vector<SheetBar>& bars,
                   const Matrix3Xd& positions) {
  const auto arm = [&](int bar, bool leaves) {
    return Eigen::Vector3d(positions.col(otherEnd(bars[bar], leaves)) -
                           positions.col(corner.joint));
  };
  const Eigen::Vector3d a = arm(corner.first, corner.leavesFirst);
  const Eigen::Vector3d b = arm(corner.second, corner.leavesSecond);
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// How far apart a bar's layers are, of what the range allows for.
double shareOfRange(const SheetBar& bar, const ShrinkRange& shrink) {
  const double wanted = (bar.mostRest - bar.leastRest) / (bar.mostRest + bar.leastRest);
  return wanted * (2 - shrink.least - shrink.most) / (shrink.most - shrink.least);
}

}  // namespace

SheetFigures computeSheetFigures(const SheetProblem& problem, const Sheet& sheet,
                                 double layerSpacing) {
  const std::vector<SheetBar> bars = sheetBars(problem);
  const std::vector<SheetCorner> corners = sheetCorners(problem.layer);
  SheetFigures figures{.iterations = sheet.iterations, .seconds = sheet.seconds};

  std::vector<double> headings;
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  std::vector<double> shares;
  for (const SheetBar& bar : bars) {
    const Eigen::Vector2d flat = sheet.positions.col(bar.to) - sheet.positions.col(bar.from);
    headings.push_back(std::atan2(flat.y(), flat.x()));
    least = std::min(least, bar.chord / flat.norm());
    most = std::max(most, bar.chord / flat.norm());
    shares.push_back(shareOfRange(bar, problem.shrink));
    figures.barsBeyondRange += bar.isBeyondRange ? 1 : 0;
  }
  figures.scaleRatio = most / least;
  const auto outlier =
      shares.begin() + std::lround((1 - kFewOutliers) * static_cast<double>(shares.size() - 1));
  std::nth_element(shares.begin(), outlier, shares.end());
  figures.fittingLayerSpacing = layerSpacing / *outlier;

  std::size_t n = 0;
  forEachLateralStrut(problem.layer, [&](const Strut& strut) {
    const SheetBar& bar = bars[n++];
    const double printed = (sheet.positions.col(bar.to) - sheet.positions.col(bar.from)).norm();
    for (const LateralField<double>& layer : problem.rest) {
      const double loss = 1 - layer.at(strut) / printed;
      ++figures.lateralStruts;
      if (loss > problem.shrink.most + kTolerance || loss < problem.shrink.least - kTolerance) {
        ++figures.strutsOutOfRange;
      }
    }
  });

  const MeanAndLargest angles = overCorners(corners, [&](const SheetCorner& corner) {
    const double printed = angleBetween(corner, [&](int bar, bool) { return headings[bar]; });
    const double wanted = angleBetween(corner, [&](int bar, bool atFrom) {
      return atFrom ? bars[bar].directionFrom : bars[bar].directionTo;
    });
    return wrapped(printed - wanted);
  });
  figures.meanAngle = angles.mean;
  figures.largestAngle = angles.largest;

  const double outermost = (static_cast<double>(problem.rest.size()) - 1) / 2 * layerSpacing;
  const Matrix3Xd top = problem.points + outermost * problem.normals;
  const Matrix3Xd bottom = problem.points - outermost * problem.normals;
  const MeanAndLargest twists = overCorners(corners, [&](const SheetCorner& corner) {
    return cornerAngle(corner, bars, top) - cornerAngle(corner, bars, bottom);
  });
  figures.meanTwist = twists.mean;
  figures.largestTwist = twists.largest;

  const Eigen::Vector2d size =
      sheet.positions.rowwise().maxCoeff() - sheet.positions.rowwise().minCoeff();
  figures.sizeX = size.x();
  figures.sizeY = size.y();
  return figures;
}

std::vector<std::string> adviseOn(const SheetFigures& sheet, const ShrinkRange& shrink) {
  std::vector<std::string> advice;
  if (sheet.strutsOutOfRange <= kFewOutliers * sheet.lateralStruts) {
    return advice;
  }
  const double range = (1 - shrink.least) / (1 - shrink.most);
  advice.push_back(fmt::format(
      "{} of {} lateral struts would have to shrink by less than {:g} % or more than {:g} %: {}",
      sheet.strutsOutOfRange, sheet.lateralStruts, 100 * shrink.least, 100 * shrink.most,
      sheet.barsBeyondRange > 0
          ? fmt::format("{} struts of the net bend so strongly that their layers alone do not fit; "
                        "with grid.layer_spacing = {:.3g} 99 % of them would",
                        sheet.barsBeyondRange, sheet.fittingLayerSpacing)
          : fmt::format("the flat sheet's scale varies by {:.3g} where the material allows for "
                        "{:.3g}; use a material of a wider range (material.least_shrinkage, "
                        "grid.max_shrinkage), a lower grid.layer_spacing or grid.curvature_cutoff, "
                        "another design.net, or cut the surface into parts that curve less",
                        sheet.scaleRatio, range)));
  return advice;
}

}  // namespace morphgrid
