#pragma once
#include "target/target.h"
#include "target/target_request.h"

namespace morphgrid {

/// Surveys a Bezier patch. Throws InputError, with the patch's place, when it has no extent;
/// Cancelled where that is requested.
std::shared_ptr<const Target> makePatchTarget(const PatchRequest& request,
                                              const Cancellation& cancellation = {});

/// Closest points of a fine triangulation of the surface.
ClosestPointQuery closestPointsOf(const Surface& surface);

}  // namespace morphgrid
