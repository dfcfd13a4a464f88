#include "benchmark/fidelity_cases.h"

#include <fmt/format.h>

#include "benchmark/random_patch.h"

namespace morphgrid {
namespace {

constexpr unsigned kSeeds = 10;

/// What is best where struts are springs: lines that cross at right angles, as their corners want.
Scene designedInSprings(Scene scene, const std::string& name) {
  scene.name = name;
  scene.design.net = NetKind::orthogonal;
  scene.design.reference = Reference::middle;
  scene.design.compensateRounds = 2;
  scene.design.optimiseSteps = 100;
  scene.design.enforceShrinkage = true;
  return scene;
}

FidelityCase sceneCase(const std::filesystem::path& folder, const std::string& name) {
  const auto load = [folder](const std::string& file) {
    return [path = folder / (file + ".toml")] { return loadScene(path); };
  };
  const auto springs = [=] { return designedInSprings(load(name)(), name + "_springs"); };
  return {name, false, load(name), springs, load(name + "_true")};
}

Scene randomScene(const std::string& name, unsigned seed) {
  Scene scene{.name = name, .title = fmt::format("Random patch {}", seed), .file = name};
  const BezierPatch patch = randomPatch(seed);
  scene.surface = PatchRequest{.controlPoints = patch.controlPoints()};
  scene.design = requestForRandomPatch(surveySurface(patch));
  return scene;
}

/// As the scenes that end in _true have it.
Scene designedForShape(Scene scene) {
  scene.material.model = Model::frame;
  scene.material.leastShrinkage = 0.02;
  scene.design.layout = Layout::conformal;
  scene.design.reference = Reference::middle;
  scene.design.compensateRounds = 10;
  scene.design.optimiseSteps = 20;
  scene.design.maxStrain = 0.03;
  scene.design.enforceShrinkage = true;
  return scene;
}

FidelityCase randomCase(unsigned seed) {
  const std::string name = fmt::format("random_{}", seed);
  return {name, true, [=] { return randomScene(name, seed); },
          [=] { return designedInSprings(randomScene(name, seed), name + "_springs"); },
          [=] { return designedForShape(randomScene(name + "_true", seed)); }};
}

}  // namespace

std::vector<FidelityCase> listFidelityCases(const std::filesystem::path& scenes) {
  std::vector<FidelityCase> cases;
  for (const char* name : {"patch", "egg_chair", "iris_petal", "face", "torso"}) {
    cases.push_back(sceneCase(scenes, name));
  }
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    cases.push_back(randomCase(seed));
  }
  return cases;
}

}  // namespace morphgrid
