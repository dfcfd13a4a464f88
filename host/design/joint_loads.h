#pragma once
#include <optional>

#include "design/material.h"

namespace morphgrid {

/// What holds the joints of a welded grid, and what its bars weigh on them: half of
/// `(density - fluid density) gravity x cross-section x printed length` at either end of a bar, in
/// the unit in which the solver has forces. Bars keep their mass and their volume: they thicken as
/// they shrink. None where nothing is asked for. Throws InputError when a support is no joint of
/// the grid.
std::optional<JointLoads> jointLoads(const StrutGrid& welded, const MaterialRequest& material);

/// Whether they hold columns of joints apart, between which a grid cannot shrink.
bool holdApart(const JointLoads& loads, const GridShape& shape);

/// What all bars of a grid with such loads weigh together, less what the fluid carries, in N.
double weightInNewtons(const StrutGrid& loaded, const MaterialRequest& material);

}  // namespace morphgrid
