#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/scene.h"
#include "gpu/device.h"

namespace morphgrid {

/// How one method ended on a random scene.
struct MethodEnd {
  Method method;
  bool converged = false;
  std::string ending;
  double energy = 0;
  /// Of the energy, the share that the CPU finds below it in double precision, downhill.
  double excess = 0;

  bool isFinite() const;
  /// Converged, it says, but the energy is not that of an equilibrium.
  bool isFalse() const;
};

/// A random scene by all methods.
struct RandomSceneResult {
  unsigned seed;
  std::string kind;  ///< Flat, mild, strong or folded, with net and layers.
  Weights weights;
  std::optional<std::string> refusal;  ///< The design's.
  std::vector<MethodEnd> ends;

  /// All have converged, to one energy.
  bool isAgreed() const;
  /// All have converged, each in an equilibrium, but not in the same.
  bool hasSeveralEquilibria() const;
};

/// Scenes of small random patches, flat to folded, 2 to 5 layers, their three weights over six
/// decades each, solved by all methods without inverse design; seeds from 1 on, those whose
/// `random: seed N` contains `only`. Prints a row where not all is as it should be; stops when the
/// user interrupts.
std::vector<RandomSceneResult> measureRandomScenes(const std::shared_ptr<Device>& device,
                                                   const std::string& only);

/// What docs/robustness.md holds between its marks.
std::string toMarkdown(const std::vector<RandomSceneResult>& results);

}  // namespace morphgrid
