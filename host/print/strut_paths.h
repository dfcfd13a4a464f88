#pragma once
#include "print/print_path.h"
#include "print/print_plan.h"

namespace morphgrid {

/// By how much joints between zones are moved from pass to pass, mm, so that they do not lie above
/// each other.
inline constexpr double kZoneShift = 0.4;

/// One pass of a strut between two hubs.
struct StrutPass {
  Eigen::Vector2d from, to;  ///< The hubs' middles.
  double share;              ///< Of the free length, laid along.
  double height;             ///< mm
  double shift;    ///< By how much the middle zone is moved towards `to`, mm, where there is room.
  double fastest;  ///< mm/s
};

/// The larger part of a strut's free length is split to both ends, the smaller is one zone in the
/// middle; each zone is laid along the strut or across it.
struct StrutZone {
  PathKind kind;
  double begin, end;     ///< From the middle of the hub at `from`, mm.
  bool isFirst, isLast;  ///< Whether it meets a hub there.
};
std::vector<StrutZone> strutZones(const PrintPlan& plan, const StrutPass& pass);

/// visit(const PrintPath&) of each zone in turn. `path` is what they are written to; it knows the
/// strut's place already.
template <typename Visit>
void visitStrut(const PrintPlan& plan, const StrutPass& pass, PrintPath& path, Visit visit);

/// Writes a zone to a path. side: 1 or -1, on which the path begins, to the left of the strut or to
/// its right; returns on which it ends.
double layZone(const PrintPlan& plan, const StrutPass& pass, const StrutZone& zone, double side,
               PrintPath& path);

template <typename Visit>
void visitStrut(const PrintPlan& plan, const StrutPass& pass, PrintPath& path, Visit visit) {
  double side = 1;
  path.joins = false;
  for (const StrutZone& zone : strutZones(plan, pass)) {
    side = layZone(plan, pass, zone, side, path);
    visit(path);
    path.joins = true;
  }
}

/// A path of the skirt or the tag: as slow as hubs.
PrintPath strokeOf(const PrintPlan& plan, std::vector<Eigen::Vector2d> points, PathKind kind,
                   double height, double fastest);

/// Writes a circle to a path, as a polygon of kRingSides that begins and ends at this angle: around
/// the circle, so that it does not narrow the hole, and with the circle's volume.
void layRing(const Eigen::Vector2d& centre, double radius, double angle, PrintPath& path);

/// visit(const PrintPath&) of a hub's rings, the outer one first: that is where the nozzle is.
/// `path` knows all but its points and flow.
template <typename Visit>
void visitRings(const PrintPlan& plan, const Eigen::Vector2d& hub, double angle, PrintPath& path,
                Visit visit) {
  path.joins = false;
  const std::vector<double>& radii = plan.hub.ringRadii;
  for (auto radius = radii.rbegin(); radius != radii.rend(); ++radius) {
    layRing(hub, *radius, angle, path);
    visit(path);
    path.joins = true;
  }
}

}  // namespace morphgrid
