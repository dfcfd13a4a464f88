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

/// A corner's printed angle less that in the target's tangent plane.
double angleError(const SheetCorner& corner, const std::vector<SheetBar>& bars,
                  const std::vector<Eigen::Vector2d>& chords) {
  const double printed = angleBetween(
      corner, [&](int bar, bool) { return std::atan2(chords[bar].y(), chords[bar].x()); });
  const double wanted = angleBetween(corner, [&](int bar, bool atFrom) {
    return atFrom ? bars[bar].directionFrom : bars[bar].directionTo;
  });
  return wrapped(printed - wanted);
}

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
double shareOfRange(const SheetBar& bar, const ShrinkBounds& bounds) {
  const ShrinkRange shrink = bounds.at(std::sqrt(bar.shortest * bar.longest));
  const double wanted = (bar.mostRest - bar.leastRest) / (bar.mostRest + bar.leastRest);
  return wanted * (2 - shrink.least - shrink.most) / (shrink.most - shrink.least);
}

std::vector<Eigen::Vector2d> chordsOf(const std::vector<SheetBar>& bars, const Sheet& sheet) {
  std::vector<Eigen::Vector2d> chords;
  for (const SheetBar& bar : bars) {
    chords.emplace_back(sheet.positions.col(bar.to) - sheet.positions.col(bar.from));
  }
  return chords;
}

void addScales(const SheetProblem& problem, const std::vector<SheetBar>& bars,
               const std::vector<Eigen::Vector2d>& chords, SheetFigures& figures) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  std::size_t n = 0;
  forEachLateralStrut(problem.layer, [&](const Strut& strut) {
    const double printed = chords[n].norm();
    const SheetBar& bar = bars[n++];
    least = std::min(least, bar.chord / printed);
    most = std::max(most, bar.chord / printed);
    figures.barsBeyondRange += bar.isBeyondRange ? 1 : 0;
    for (const LateralField<double>& layer : problem.rest) {
      const double loss = 1 - layer.at(strut) / printed;
      const ShrinkRange range = problem.shrink.at(printed);
      const bool fits = loss <= range.most + kTolerance && loss >= range.least - kTolerance;
      ++figures.lateralStruts;
      figures.strutsOutOfRange += fits ? 0 : 1;
    }
  });
  figures.scaleRatio = most / least;
}

/// The share of the range that all but a few bars stay below.
double usualShareOfRange(const SheetProblem& problem, const std::vector<SheetBar>& bars) {
  std::vector<double> shares;
  for (const SheetBar& bar : bars) shares.push_back(shareOfRange(bar, problem.shrink));
  const double last = static_cast<double>(shares.size() - 1);
  const auto usual = shares.begin() + std::lround((1 - kFewOutliers) * last);
  std::nth_element(shares.begin(), usual, shares.end());
  return *usual;
}

}  // namespace

SheetFigures computeSheetFigures(const SheetProblem& problem, const Sheet& sheet,
                                 double layerSpacing) {
  const std::vector<SheetBar> bars = sheetBars(problem);
  const std::vector<SheetCorner> corners = sheetCorners(problem.layer);
  const std::vector<Eigen::Vector2d> chords = chordsOf(bars, sheet);
  SheetFigures figures{.iterations = sheet.iterations, .seconds = sheet.seconds};
  addScales(problem, bars, chords, figures);
  figures.fittingLayerSpacing = layerSpacing / usualShareOfRange(problem, bars);

  const MeanAndLargest angles = overCorners(
      corners, [&](const SheetCorner& corner) { return angleError(corner, bars, chords); });
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

Eigen::VectorXd printedAngleErrors(const SheetProblem& problem, const Sheet& sheet) {
  const std::vector<SheetBar> bars = sheetBars(problem);
  const std::vector<Eigen::Vector2d> chords = chordsOf(bars, sheet);
  Eigen::VectorXd errors = Eigen::VectorXd::Zero(problem.layer.layerVertexCount());
  for (const SheetCorner& corner : sheetCorners(problem.layer)) {
    double& largest = errors[corner.joint];
    largest = std::max(largest, std::abs(angleError(corner, bars, chords)));
  }
  return errors;
}

std::vector<std::string> adviseOn(const SheetFigures& sheet, const ShrinkBounds& bounds) {
  const ShrinkRange& shrink = bounds.material;
  std::vector<std::string> advice;
  if (sheet.strutsOutOfRange <= kFewOutliers * sheet.lateralStruts) {
    return advice;
  }
  const double range = (1 - shrink.least) / (1 - shrink.most);
  advice.push_back(fmt::format(
      "{} of {} lateral struts would have to shrink by less than {:g} % or more than {:g} %{}: {}",
      sheet.strutsOutOfRange, sheet.lateralStruts, 100 * shrink.least, 100 * shrink.most,
      bounds.hubDiameter > 0 ? ", hubs by their own share" : "",
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
