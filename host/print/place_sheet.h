#pragma once
#include <Eigen/Core>

#include "print/printer.h"

namespace morphgrid {

/// How a sheet lies on a bed.
struct SheetPlacing {
  int degrees = 0;           ///< Turned by so much, counter-clockwise, in [0, 180).
  double room = 0;           ///< By how much larger it would still fit; below 1 it does not.
  Eigen::Vector2d extent{};  ///< Along x and y, hubs included, mm.
};

/// Turned as leaves most room. points: 2 x n with n >= 1, mm; hubs: their diameter at each point.
SheetPlacing placeSheet(const Eigen::Matrix2Xd& points, double hubs, const Printer& printer);

/// What to say where a hub of that diameter, mm, has no room on the bed.
std::string whyNoRoom(double hub, const Printer& printer);

/// The points turned so, with the middle of their extent at the bed's; from the bed's corner.
Eigen::Matrix2Xd onBed(const Eigen::Matrix2Xd& points, int degrees, const Printer& printer);

/// The convex hull's corners, counter-clockwise. points: 2 x n with n >= 1.
Eigen::Matrix2Xd convexOutline(const Eigen::Matrix2Xd& points);

}  // namespace morphgrid
