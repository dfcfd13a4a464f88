#pragma once
#include <optional>
#include <string>

#include "app/pipeline.h"
#include "benchmark/frame_judgement.h"
#include "render/camera.h"

namespace morphgrid {

/// A design, simulated.
struct FidelityRun {
  RunRecord record;
  double maxShrinkage;       ///< What the material can lose, a share.
  FrameJudgement frame;      ///< In which people print it.
  Eigen::Matrix3Xd targets;  ///< Where the middle layer's vertices should lie.
  Eigen::Matrix3Xd middle;   ///< Those vertices as they come to rest in the frame, brought to the
                             ///< targets.
  View view;                 ///< Where pictures of it are taken from.
};

/// The designs of a target.
struct FidelityTrio {
  std::string name;
  bool random;
  FidelityRun papers;
  FidelityRun springs;  ///< For the shape, in the paper's model.
  FidelityRun ours;     ///< For the shape, in the frame.
};

/// Runs a scene, its report and files without pictures going to `folder`, and judges what comes of
/// it with bars of those sizes. Throws as runScene(), and DeviceError when the device fails on the
/// way.
FidelityRun runForFidelity(Scene scene, const std::filesystem::path& folder,
                           const DeviceOptions& device, const MaterialRequest& bars);

/// In the frame, from the flat sheet: RMS distance at most 0.1 % and largest at most 0.4 % of the
/// diagonal, no strut over what it can shrink and none that would have to grow.
bool meetsGoal(const FidelityRun& run);

}  // namespace morphgrid
