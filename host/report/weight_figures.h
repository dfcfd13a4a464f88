#pragma once
#include <optional>
#include <string>
#include <vector>

namespace morphgrid {

/// What weight does to a frame.
struct WeightFigures {
  double newtons;  ///< Of all bars, less what the fluid carries.
  /// How far weight moves the joint that it moves the most, in the scene's unit of length: to first
  /// order, from where the grid is with it. Of `multigrid` alone.
  std::optional<double> sag;
};

/// Where weight dominates, with the way out, for the user. diagonal: of the grid as printed.
std::vector<std::string> adviseOn(const WeightFigures& weight, double diagonal);

}  // namespace morphgrid
