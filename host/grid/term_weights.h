#pragma once
#include <array>
#include <optional>

namespace morphgrid {

/// Weights of the types of constraints that have one for all of a grid. Defaults are the scene's.
struct TermWeights {
  double angle = 1;  ///< w of every corner, >= 0.
};

struct TermWeight {
  const char* name;  ///< In messages; arrays of states are called NAME_weight.
  double TermWeights::*value;
  /// What states hold that have no such array, as they are from before there was this weight.
  std::optional<double> before;
};

/// All of them, for those who treat them alike. The order is part of a checkpoint's digest.
inline constexpr std::array kTermWeights{
    TermWeight{"angle", &TermWeights::angle, std::nullopt},
};
static_assert(sizeof(TermWeights) == kTermWeights.size() * sizeof(double),
              "every weight has a line in the table");

}  // namespace morphgrid
