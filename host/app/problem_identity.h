#pragma once
#include <map>
#include <string>

#include "app/design_scene.h"

namespace morphgrid {

/// What a checkpoint and the run that goes on from it must have in common. Tolerances, limits and
/// outputs are not among it: they may change on the way.
struct ProblemIdentity {
  /// Digest of all numbers that the run solves with: its grids (shape, spacing, printed positions,
  /// rest lengths, stiffnesses, angle weight, loads), method, targets and bounds of inverse design.
  std::string digest;
  /// Some of what leads to them, by names for people: to tell what differs.
  std::map<std::string, std::string> settings;

  bool operator==(const ProblemIdentity&) const = default;
};

ProblemIdentity identifyProblem(const Scene& scene, const SceneDesign& designed);

/// One a line, indented: "name: ... in the checkpoint, ... in the scene"; where no setting differs,
/// what may.
std::string describeDifferences(const ProblemIdentity& checkpoint, const ProblemIdentity& scene);

}  // namespace morphgrid
