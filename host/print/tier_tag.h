#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "print/print_plan.h"

namespace morphgrid {

/// The tier's number, from 1, in the first cell, with a line to the hub at its corner: it tells
/// tiers apart, their corner 0, 0 and their upper side, and is snapped off before the bath. Strokes
/// of points on the bed; none where the cell has no room for a number that stays kTagGap from
/// struts.
std::vector<std::vector<Eigen::Vector2d>> tagOf(const PrintPlan& plan, int tier);

/// Digits on a line that joins them, about `middle`, read along a unit vector; size: a digit's
/// width, mm. The first stroke begins before them, halfway up.
std::vector<std::vector<Eigen::Vector2d>> numberStrokes(const std::string& digits,
                                                        const Eigen::Vector2d& middle,
                                                        const Eigen::Vector2d& along, double size);

/// Between the number and struts, mm.
inline constexpr double kTagGap = 1;
/// Passes that have the tag.
inline constexpr int kTagPasses = 3;

}  // namespace morphgrid
