#pragma once
#include <array>

namespace morphgrid {

/// Weights of the types of constraints that have one for all of a grid. Defaults are the scene's.
struct TermWeights {
  double angle = 1;      ///< w of every corner between struts of a layer, >= 0.
  double postAngle = 1;  ///< w of every corner between a strut of a layer and a post, >= 0.

  static constexpr TermWeights ofAllCorners(double angle) { return {angle, angle}; }
};

struct TermWeight {
  const char* name;  ///< In messages; arrays of states are called NAME_weight.
  double TermWeights::*value;
  /// Whose value it had in states that have no such array, as they are from before there was it.
  double TermWeights::*before = nullptr;
};

/// All of them, for those who treat them alike. The order is part of a checkpoint's digest.
inline constexpr std::array kTermWeights{
    TermWeight{"angle", &TermWeights::angle},
    TermWeight{"post_angle", &TermWeights::postAngle, &TermWeights::angle},
};
static_assert(sizeof(TermWeights) == kTermWeights.size() * sizeof(double),
              "every weight has a line in the table");

}  // namespace morphgrid
