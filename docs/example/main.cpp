// Designs and solves a scene with the library, and prints how close the result comes and what is to
// be printed.
#include <fmt/format.h>

#include "app/scene.h"
#include "app/simulate_scene.h"

int main(int argc, char** argv) {
  using namespace morphgrid;
  try {
    const Scene scene = loadScene(argc > 1 ? argv[1] : "scene.toml", {"output.pictures=false"});
    const SceneDesign designed = designScene(scene);
    RunContext context{.device = std::make_shared<Device>(DeviceOptions{})};
    CheckpointKeeper keeper({}, {});
    const auto [record, stage, targetFromGrid] =
        simulateScene(scene, designed, context, keeper, true);
    fmt::print("{} vertices, {:.3f} % from the target\n", stage.grid.shape.vertexCount(),
               record.distance->rmsPercent);
    fmt::print("first strut: rest length {:.4f}\n", stage.grid.rest.u.front());
    return stage.equilibrium.converged ? 0 : 3;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
