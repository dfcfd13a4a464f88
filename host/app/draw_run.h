#pragma once
#include "app/simulate_scene.h"
#include "surface/mesh_sampling.h"

namespace morphgrid {

/// Puts a simulation's result on the context's device and draws it, from nothing but what the
/// simulation holds in the end. sampling: of a mesh; may be null.
void drawRun(const Scene& scene, const SceneDesign& designed, const MeshSampling* sampling,
             Simulation& simulation, RunContext& context);

}  // namespace morphgrid
