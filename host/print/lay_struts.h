#pragma once
#include "print/print_plan.h"

namespace morphgrid {

/// A lateral strut as a run left it.
struct DesignedStrut {
  Strut strut;
  double printed;  ///< Length on the run's sheet, scene units.
  double rest;     ///< Length when morphed, scene units.

  double shrink(double enlargement) const { return 1 - rest / (enlargement * printed); }
};

/// The lateral struts of a grid, in the order of forEachLateralStrut().
std::vector<DesignedStrut> designedStruts(const StrutGrid& grid);

/// How much larger than the run's sheet it is best printed: 1 where that leaves no strut out of
/// range, else in [0.8, 1.3] by the fewest struts out of range, then the least sum of squares of
/// what is missing, then so that the median strut is in the middle of its range.
double bestEnlargement(const std::vector<DesignedStrut>& struts, const StrutLay& lay, double scale);

/// Fills the plan's shares, rest lengths and figures; scale, enlargement and hub are set.
void layStruts(const StrutGrid& grid, PrintPlan& plan);

}  // namespace morphgrid
