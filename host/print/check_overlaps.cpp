#include "print/check_overlaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "print/print_record.h"

namespace morphgrid {
namespace {

using Eigen::Vector2d;

/// A strut's middle line.
struct Axis {
  Strut strut;
  Vector2d from, to, middle;
  double half;  ///< Of its length, mm.

  bool endsAt(int vertex) const { return vertex == strut.from || vertex == strut.to; }
  bool meets(const Axis& other) const { return endsAt(other.strut.from) || endsAt(other.strut.to); }
  double distanceTo(const Vector2d& point) const {
    const Vector2d along = to - from;
    const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (from + share * along - point).norm();
  }
  double sideOf(const Vector2d& point) const {
    const Vector2d a = to - from, b = point - from;
    return a.x() * b.y() - a.y() * b.x();
  }
  bool crosses(const Axis& other) const {
    return (other.middle - middle).norm() < half + other.half &&
           sideOf(other.from) * sideOf(other.to) < 0 && other.sideOf(from) * other.sideOf(to) < 0;
  }
};

std::vector<Axis> axesOf(const PrintPlan& plan, int tier) {
  std::vector<Axis> axes;
  forEachLateralStrut(plan.shape, [&](const Strut& strut) {
    if (strut.layer != tier) return;
    const Vector2d from = plan.positions.col(strut.from), to = plan.positions.col(strut.to);
    axes.push_back({strut, from, to, (from + to) / 2, (to - from).norm() / 2});
  });
  return axes;
}

bool isInTheWay(const PrintPlan& plan, const std::vector<Axis>& axes, std::size_t own) {
  const Axis& axis = axes[own];
  for (std::size_t n = own + 1; n < axes.size(); ++n) {
    if (axes[n].crosses(axis) && !axes[n].meets(axis)) return true;
  }
  const double clearance = (plan.hub.diameter + plan.strutWidth()) / 2;
  const int begin = plan.shape.index(0, axis.strut.layer);
  for (int hub = begin; hub < begin + plan.shape.layerVertexCount(); ++hub) {
    const Vector2d at = plan.positions.col(hub);
    if (axis.endsAt(hub) || (at - axis.middle).norm() > axis.half + clearance) continue;
    if (axis.distanceTo(at) < clearance) return true;
  }
  return false;
}

int countCloseHubs(const PrintPlan& plan, int tier) {
  const auto hubs =
      plan.positions.middleCols(plan.shape.index(0, tier), plan.shape.layerVertexCount());
  int count = 0;
  for (Eigen::Index n = 0; n + 1 < hubs.cols(); ++n) {
    const auto others = hubs.rightCols(hubs.cols() - n - 1);
    const double nearest = (others.colwise() - hubs.col(n)).colwise().norm().minCoeff();
    count += nearest < plan.hub.diameter ? 1 : 0;
  }
  return count;
}

}  // namespace

std::optional<std::string> findOverlaps(const PrintPlan& plan) {
  int struts = 0;
  int hubs = 0;
  std::string first;
  for (int tier = 0; tier < plan.shape.layers; ++tier) {
    hubs += countCloseHubs(plan, tier);
    const std::vector<Axis> axes = axesOf(plan, tier);
    for (std::size_t n = 0; n < axes.size(); ++n) {
      if (!isInTheWay(plan, axes, n)) continue;
      if (struts++ == 0) first = ", the first " + nameOf(plan.shape, axes[n].strut);
    }
  }
  if (struts + hubs == 0) return std::nullopt;
  return fmt::format(
      "the sheet overlaps itself: {} struts cross others or run into their hubs{}, {} hubs of "
      "{:.2f} "
      "mm overlap: a larger scale, fewer nodes or thinner pins (--pin) would do where cells are "
      "narrow, another net where the sheet folds",
      struts, first, hubs, plan.hub.diameter);
}

}  // namespace morphgrid
