#pragma once
#include "print/print_path.h"
#include "print/print_plan.h"

namespace morphgrid {

/// Walks a tier as it is printed: pass by pass the lines along u in turns, each with the rings of
/// its hubs, then those along v from the corner where u ended; then the tubes that carry the next
/// tier. Struts end at rings, so that nothing is laid twice.
void visitTier(const PrintPlan& plan, int tier, TierVisitor& visitor);

/// The line around a tier, in the first pass: kSkirtGap from all of it, closed.
std::vector<Eigen::Vector2d> skirtOf(const PrintPlan& plan);

}  // namespace morphgrid
