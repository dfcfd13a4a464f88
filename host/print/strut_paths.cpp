#include "print/strut_paths.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morphgrid {
namespace {

// Shares of a line's width: how far lines run into a ring, and how far lines along stop short of a
// zone across, whose own half width they would overlap else.
constexpr double kAnchor = 0.5;
constexpr double kLap = 0.25;
/// Zones at the ends are moved only where they stay longer than this, mm.
constexpr double kRoomToShift = 1.5;

/// Where a strut runs, and how its lines lie in it.
struct StrutFrame {
  Eigen::Vector2d origin, along, left;
  double pitch;
  double half;  ///< From the middle line to the outermost, mm.

  Eigen::Vector2d at(double distance, double offset) const {
    return origin + distance * along + offset * left;
  }
};

StrutFrame strutFrameOf(const PrintPlan& plan, const StrutPass& pass) {
  StrutFrame frame;
  frame.origin = pass.from;
  frame.along = (pass.to - pass.from).normalized();
  frame.left = {-frame.along.y(), frame.along.x()};
  frame.pitch = plan.strutBead(pass.height).pitch();
  frame.half = (plan.material.strut.lines - 1) / 2.0 * frame.pitch;
  return frame;
}

/// Lines along the strut, to and fro.
double layAlong(const StrutFrame& frame, int lines, double begin, double end, double side,
                PrintPath& path) {
  for (int line = 0; line < lines; ++line) {
    const double offset = side * (frame.half - line * frame.pitch);
    path.points.push_back(frame.at(line % 2 == 0 ? begin : end, offset));
    path.points.push_back(frame.at(line % 2 == 0 ? end : begin, offset));
  }
  return -side;
}

/// A zigzag across the strut; its lines are spread to fill the zone, and lay what as many lines
/// along it would lay, save the link that joins one zigzag to the next.
double layAcross(const StrutFrame& frame, int lines, double begin, double end, double side,
                 PrintPath& path) {
  const int count = std::max(1, static_cast<int>(std::lround((end - begin) / frame.pitch)));
  const double step = (end - begin) / count;
  for (int line = 0; line < count; ++line) {
    const double distance = begin + (line + 0.5) * step;
    path.points.push_back(frame.at(distance, side * frame.half));
    path.points.push_back(frame.at(distance, -side * frame.half));
    side = -side;
  }
  path.flow = (lines * (end - begin) - step) / (2 * frame.half * count + (count - 1) * step);
  return side;
}

}  // namespace

std::vector<StrutZone> strutZones(const PrintPlan& plan, const StrutPass& pass) {
  using enum PathKind;
  const double begin = plan.hub.diameter / 2;
  const double end = (pass.to - pass.from).norm() - begin;
  const double smaller = std::min(pass.share, 1 - pass.share);
  const PathKind outer = pass.share >= 0.5 ? along : across;
  if (smaller == 0) {
    return {{outer, begin, end, true, true}};
  }
  const double middle = smaller * (end - begin);
  const double outside = (end - begin - middle) / 2;
  const double first = begin + outside + (outside > kRoomToShift ? pass.shift : 0);
  return {{outer, begin, first, true, false},
          {outer == along ? across : along, first, first + middle, false, false},
          {outer, first + middle, end, false, true}};
}

double layZone(const PrintPlan& plan, const StrutPass& pass, const StrutZone& zone, double side,
               PrintPath& path) {
  const StrutFrame frame = strutFrameOf(plan, pass);
  const double width = plan.printer.lineWidth;
  const bool isAlong = zone.kind == PathKind::along;
  // The middle of a bead laid along ends half a width before the bead does.
  const double atHub = isAlong ? (0.5 - kAnchor) * width : -kAnchor * width;
  const double inside = isAlong ? (0.5 - kLap) * width : 0;
  const double begin = zone.begin + (zone.isFirst ? atHub : inside);
  const double end = zone.end - (zone.isLast ? atHub : inside);
  const Lay& lay = isAlong ? plan.material.along : plan.material.across;
  path.points.clear();
  path.kind = zone.kind;
  path.bead = plan.strutBead(pass.height);
  path.speed = std::min(lay.speed, pass.fastest);
  path.flow = 1;
  const int lines = plan.material.strut.lines;
  return isAlong ? layAlong(frame, lines, begin, end, side, path)
                 : layAcross(frame, lines, begin, end, side, path);
}

PrintPath strokeOf(const PrintPlan& plan, std::vector<Eigen::Vector2d> points, PathKind kind,
                   double height, double fastest) {
  PrintPath path;
  path.points = std::move(points);
  path.kind = kind;
  path.bead = plan.strutBead(height);
  path.speed = std::min(plan.material.hub.speed, fastest);
  return path;
}

void layRing(const Eigen::Vector2d& centre, double radius, double angle, PrintPath& path) {
  constexpr double kStep = 2 * std::numbers::pi / kRingSides;
  const double corners = radius / std::cos(kStep / 2);
  path.points.clear();
  for (int n = 0; n <= kRingSides; ++n) {
    const double turn = angle + n * kStep;
    path.points.push_back(centre + corners * Eigen::Vector2d(std::cos(turn), std::sin(turn)));
  }
  path.flow = kStep / 2 / std::tan(kStep / 2);
}

}  // namespace morphgrid
