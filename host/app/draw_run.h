#pragma once
#include "app/simulate_scene.h"
#include "surface/mesh_sampling.h"

namespace morphgrid {

/// Draws a simulation's result by the context's device, from nothing but what the simulation holds
/// in the end, and takes what the stage has there off it. sampling: of a mesh; may be null.
void drawRun(const Scene& scene, const SceneDesign& designed, const MeshSampling* sampling,
             Simulation& simulation, RunContext& context);

}  // namespace morphgrid
