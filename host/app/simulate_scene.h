#pragma once
#include <Eigen/Geometry>

#include "app/design_scene.h"
#include "app/stages.h"

namespace morphgrid {

/// Where a designed scene comes to rest, and the report about it.
struct Simulation {
  RunRecord record;                  ///< Without the total time and what the device failed at.
  Stage stage;                       ///< The last one.
  Eigen::Isometry3d targetFromGrid;  ///< Without a target: from the last stage to where it began.
};

/// Solves in the plane, stacks, solves in space, with the inverse design that the scene asks for.
/// The keeper says where to begin. Throws Cancelled where scene.solve is
/// cancelled, because nobody waits for the result, and when the user interrupts before anything is
/// solved.
Simulation simulateScene(const Scene& scene, const SceneDesign& designed, RunContext& context,
                         CheckpointKeeper& keeper, bool quiet);

}  // namespace morphgrid
