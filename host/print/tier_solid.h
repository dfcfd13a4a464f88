#pragma once
#include "print/print_plan.h"

namespace morphgrid {

/// A closed surface; lengths in mm.
struct SolidMesh {
  Eigen::Matrix3Xd points;
  Eigen::Matrix3Xi triangles;  ///< Indices of points, counter-clockwise seen from outside.
};

/// A tier as it is printed, without its tag: struts between hubs, hubs with their holes, tubes on
/// them unless it is the top one. One closed mesh: every edge has two triangles, which run along it
/// in either direction. Struts are as wide as planned and end at their hubs, which are polygons;
/// holes are nowhere narrower than their diameter.
SolidMesh tierSolid(const PrintPlan& plan, int tier);

}  // namespace morphgrid
