#pragma once
#include <limits>
#include <optional>
#include <string>

namespace morphgrid {

/// A bound that multigrid must keep, and one to aim at.
struct Bounds {
  double must;
  double aim;
};

/// What multigrid is to reach on a problem, from flat to kEnergyError.
struct SolveTarget {
  std::optional<Bounds> seconds;
  /// Share of the time that `reference` takes in the same run.
  std::optional<Bounds> shareOfReference;
  std::optional<Bounds> cycles;  ///< V-cycles, in equivalents on the finest grid.
};

/// Empty when nothing is wanted of the problem.
SolveTarget targetOf(const std::string& problem);

constexpr double kMostBytesPerVertex = 900;  ///< On the device, three layers.
/// What does not grow with the grid weighs more on smaller ones.
constexpr int kFewestBoundedVertices = 10000;
/// Cost per vertex of a million vertices over that of 25,000.
constexpr double kLargestGrowth = 1.3;

}  // namespace morphgrid
