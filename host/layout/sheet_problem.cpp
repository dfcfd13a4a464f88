#include "layout/sheet_problem.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace morphgrid {
namespace {

// Of the material's range, at either end, where it is wide enough: for what is corrected later.
constexpr double kMargin = 0.01;
constexpr double kMarginShare = 0.1;

/// Directions in the tangent plane at each joint, counted from an axis there.
class TangentPlanes {
 public:
  explicit TangentPlanes(const SheetProblem& problem) : normals_(problem.normals) {
    axes_ = Eigen::Matrix3Xd::Zero(3, problem.points.cols());
    forEachLateralStrut(problem.layer, [&](const Strut& strut) {
      const Eigen::Vector3d chord = problem.points.col(strut.to) - problem.points.col(strut.from);
      for (const int joint : {strut.from, strut.to}) {
        if (axes_.col(joint).isZero(0)) {
          const Eigen::Vector3d normal = normals_.col(joint);
          axes_.col(joint) = (chord - chord.dot(normal) * normal).normalized();
        }
      }
    });
  }

  double direction(int joint, const Eigen::Vector3d& chord) const {
    const Eigen::Vector3d axis = axes_.col(joint);
    const Eigen::Vector3d normal = normals_.col(joint);
    return std::atan2(chord.dot(normal.cross(axis)), chord.dot(axis));
  }

 private:
  const Eigen::Matrix3Xd& normals_;
  Eigen::Matrix3Xd axes_;
};

}  // namespace

double wrapped(double angle) {
  constexpr double turn = 2 * std::numbers::pi;
  return angle - turn * std::round(angle / turn);
}

std::vector<SheetBar> sheetBars(const SheetProblem& problem) {
  const TangentPlanes planes(problem);
  const ShrinkBounds& shrink = problem.shrink;
  const ShrinkRange& material = shrink.material;
  const double margin = std::min(kMargin, kMarginShare * (material.most - material.least));
  ShrinkBounds inside = shrink;
  inside.material = {material.least + margin, material.most - margin};
  std::vector<SheetBar> bars;
  bars.reserve(problem.layer.lateralStrutCount());
  forEachLateralStrut(problem.layer, [&](const Strut& strut) {
    const Eigen::Vector3d chord = problem.points.col(strut.to) - problem.points.col(strut.from);
    SheetBar bar{.from = strut.from,
                 .to = strut.to,
                 .chord = chord.norm(),
                 .directionFrom = planes.direction(strut.from, chord),
                 .directionTo = planes.direction(strut.to, chord),
                 .leastRest = problem.rest.front().at(strut),
                 .mostRest = problem.rest.front().at(strut)};
    for (const LateralField<double>& layer : problem.rest) {
      bar.leastRest = std::min(bar.leastRest, layer.at(strut));
      bar.mostRest = std::max(bar.mostRest, layer.at(strut));
    }
    bar.isBeyondRange = shrink.shortestFor(bar.mostRest) > shrink.longestFor(bar.leastRest);
    bar.shortest = inside.shortestFor(bar.mostRest);
    bar.longest = inside.longestFor(bar.leastRest);
    if (bar.shortest > bar.longest) {
      bar.shortest = bar.longest = std::sqrt(bar.shortest * bar.longest);
    }
    bars.push_back(bar);
  });
  return bars;
}

std::vector<SheetCorner> sheetCorners(const GridShape& layer) {
  struct Leaving {
    int u = -1, v = -1;
  };
  std::vector<Leaving> leaving(layer.layerVertexCount());
  int count = 0;
  forEachLateralStrut(layer, [&](const Strut& strut) {
    (strut.direction == Strut::Direction::u ? leaving[strut.from].u : leaving[strut.from].v) =
        count++;
  });
  std::vector<SheetCorner> corners;
  corners.reserve(static_cast<std::size_t>(4) * layer.layerCellCount());
  forEachCell(layer, [&](const Cell& cell) {
    const int low = leaving[cell.vertex(0, 0)].u;
    const int left = leaving[cell.vertex(0, 0)].v;
    const int high = leaving[cell.vertex(0, 1)].u;
    const int right = leaving[cell.vertex(1, 0)].v;
    corners.push_back({cell.vertex(0, 0), low, left, true, true});
    corners.push_back({cell.vertex(1, 0), right, low, true, false});
    corners.push_back({cell.vertex(1, 1), high, right, false, false});
    corners.push_back({cell.vertex(0, 1), left, high, false, true});
  });
  return corners;
}

}  // namespace morphgrid
