#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "benchmark/solve_comparison.h"

namespace morphgrid {

/// What one problem took, a line a method, and how that compares with what is wanted.
std::string describe(const Comparison& comparison);

/// Cost per vertex of the largest problem over that of the one nearest to 25,000 vertices; empty
/// with fewer than two problems of three layers.
std::string describeGrowth(const std::vector<Comparison>& comparisons);

nlohmann::json toJson(const Comparison& comparison);

/// Time over vertices on logarithmic axes, a line a method, as SVG. Times to kEnergyError; hollow
/// marks are solves that were cut short.
std::string drawTimes(const std::vector<Comparison>& comparisons);

}  // namespace morphgrid
