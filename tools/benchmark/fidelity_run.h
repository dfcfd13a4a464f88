#pragma once
#include <optional>
#include <string>

#include "app/pipeline.h"
#include "render/camera.h"

namespace morphgrid {

/// A design, simulated.
struct FidelityRun {
  RunRecord record;
  double maxShrinkage;       ///< What the material can lose, a share.
  Eigen::Matrix3Xd targets;  ///< Where the middle layer's vertices should lie.
  Eigen::Matrix3Xd middle;   ///< Those vertices as they come to rest, brought to the targets.
  View view;                 ///< Where pictures of it are taken from.
};

/// The two designs of a target.
struct FidelityPair {
  std::string name;
  bool random;
  FidelityRun papers;
  FidelityRun ours;
};

/// Runs a scene, its report and files without pictures going to `folder`. Throws as runScene(), and
/// DeviceError when the device fails on the way.
FidelityRun runForFidelity(Scene scene, const std::filesystem::path& folder,
                           const DeviceOptions& device);

/// RMS distance at most 0.1 % and largest at most 0.4 % of the diagonal, no strut over what it can
/// shrink and none that would have to grow; where inverse design looked, the printed sheet gets
/// there.
bool meetsGoal(const FidelityRun& run);

}  // namespace morphgrid
