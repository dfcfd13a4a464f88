#include "benchmark/robustness_cases.h"

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "app/design_scene.h"
#include "benchmark/random_patch.h"
#include "core/error.h"

namespace morphgrid {
namespace {

using Overrides = std::vector<std::string>;

constexpr double kAsDesigned = 0;  ///< For a layer spacing.

/// With layers `tau` spacings apart, even where Eq. 21 forbids it for the shrinkage.
GridDesign withLayerSpacing(GridDesign design, double tau) {
  if (tau != kAsDesigned) {
    design.layerSpacing = tau * design.spacing;
  }
  const double shrink = largestBendShrink(design);
  if (shrink >= 1) {
    throw InputError(fmt::format("a strut would have to shrink by {:.0f} %", 100 * shrink));
  }
  return design;
}

/// Makes cases from the scene files of a folder.
class SceneCases {
 public:
  explicit SceneCases(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::function<GridDesign()> design(const std::string& scene, const Overrides& overrides,
                                     double tau = kAsDesigned) const {
    return [file = folder_ / (scene + ".toml"), overrides, tau] {
      return withLayerSpacing(designScene(loadScene(file, overrides)).design, tau);
    };
  }

 private:
  std::filesystem::path folder_;
};

std::string nodes(int count) { return fmt::format("grid.nodes_long={}", count); }

std::function<GridDesign()> bent(const BendAngleRequest& request, int layers, double tau) {
  return [=] { return designFromBendAngles(request, layers, tau); };
}

GridDesign randomDesign(unsigned seed) {
  const BezierPatch patch = randomPatch(seed);
  const SurfaceSurvey survey = surveySurface(patch);
  const DesignRequest request = requestForRandomPatch(survey);
  const GridSize size = chooseGridSize(survey, request);
  return designGrid(measureSurface(patch, size.nodesU, size.nodesV, size.curvatureLimit), size,
                    request.layers);
}

/// Moves every vertex by up to `amount` spacings along each axis.
std::function<void(StrutGrid&)> shake(double amount) {
  return [amount](StrutGrid& grid) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(-1, 1);
    grid.positions = grid.positions.unaryExpr(
        [&](double x) { return x + amount * grid.spacing * share(random); });
  };
}

/// Multiplies every strut's stiffness by 1/spread to spread, evenly in the logarithm.
void spreadStiffness(StrutGrid& grid, double spread) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-1, 1);
  forEachStrut(grid.shape, [&](const Strut& strut) {
    valueAt(grid.stiffness, strut) *= std::pow(spread, exponent(random));
  });
}

void addWeights(std::vector<RobustnessCase>& cases, const SceneCases& scenes) {
  for (const char* scene : {"egg_chair", "patch"}) {
    const auto design = scenes.design(scene, {});
    for (const double angle : {0.0, 0.001, 0.01, 0.1, 10.0, 1000.0}) {
      cases.push_back(
          {"weights", fmt::format("{}, angle {:g}", scene, angle), design, {.angle = angle}});
    }
    for (const double vertical : {0.005, 5000.0}) {
      cases.push_back({"weights",
                       fmt::format("{}, vertical {:g}", scene, vertical),
                       design,
                       {.vertical = vertical}});
    }
    cases.push_back({"weights",
                     fmt::format("{}, random stiffness 1e-3 to 1e3", scene),
                     design,
                     {},
                     [](StrutGrid& grid) { spreadStiffness(grid, 1000); }});
  }
}

void addLayerSpacings(std::vector<RobustnessCase>& cases, const SceneCases& scenes) {
  for (const char* scene : {"egg_chair", "patch", "iris_petal", "cup"}) {
    for (const double tau : {0.1, 0.2, 0.35, 0.7, 1.0, 1.4}) {
      cases.push_back(
          {"tau", fmt::format("{}, tau {:g}", scene, tau), scenes.design(scene, {nodes(40)}, tau)});
    }
  }
}

void addLayerCounts(std::vector<RobustnessCase>& cases, const SceneCases& scenes) {
  for (int layers = 2; layers <= 8; ++layers) {
    cases.push_back(
        {"layers", fmt::format("egg_chair, {} layers", layers),
         scenes.design("egg_chair", {nodes(40), fmt::format("grid.layers={}", layers)}, 0.35)});
  }
  cases.push_back(
      {"layers", "6 x 5 nodes, 64 layers", bent({6, 5, 1, 0.1, 0.1, -0.05, 0.1}, 64, 0.05)});
}

void addShapes(std::vector<RobustnessCase>& cases) {
  const auto add = [&](const char* name, const BendAngleRequest& request, int layers = 3,
                       double tau = 0.35) {
    cases.push_back({"shapes", name, bent(request, layers, tau)});
  };
  add("1000 x 3, half a turn", {1000, 3, 1, 0.003, 0.003, 0, 0});
  add("3 x 1000, half a turn", {3, 1000, 1, 0, 0, 0.003, 0.003});
  add("1000 x 3, spirals of 3 turns", {1000, 3, 1, 0.04, -0.04, 0, 0});
  add("1000 x 3, saddle", {1000, 3, 1, 0.003, 0.003, -0.1, -0.1});
  add("1 x 1000, half a turn", {1, 1000, 1, 0, 0, 0.003, 0.003});
  add("1000 x 1, half a turn", {1000, 1, 1, 0.003, 0.003, 0, 0});
  add("1 x 1", {1, 1, 1, 0.3, 0.3, 0.2, 0.2});
  add("1 x 1, two layers", {1, 1, 1, 0.3, 0.3, 0.2, 0.2}, 2);
  add("30 x 3 (the strip)", {30, 3, 1, 1, -1, 0, 0}, 4, 0.15);
  add("60 x 3, tight spirals", {60, 3, 1, 1.2, -1.2, 0, 0}, 3, 0.15);
  add("24 x 24, flat", {24, 24, 1, 0, 0, 0, 0});
  add("24 x 24, half a sphere", {24, 24, 1, 0.13, 0.13, 0.13, 0.13});
}

void addThin(std::vector<RobustnessCase>& cases, const SceneCases& scenes) {
  const auto add = [&](const char* scene, const Overrides& overrides, double tau,
                       const char* remark = "") {
    const std::string thickness = tau == kAsDesigned ? "" : fmt::format(", tau {:g}", tau);
    cases.push_back({"thin", fmt::format("{}{}{}", scene, thickness, remark),
                     scenes.design(scene, overrides, tau)});
  };
  add("patch", {}, 0.1);
  add("patch", {nodes(100)}, 0.1, ", 100 nodes");
  add("patch", {}, 0.05);
  add("face", {}, kAsDesigned, " as designed");
  add("face", {}, 0.13);
  add("face", {}, 0.08);
  add("face", {nodes(70)}, 0.13, ", 70 nodes");
  add("torso", {}, kAsDesigned, " as designed");
  add("torso", {}, 0.17);
  add("torso", {}, 0.05);
}

void addStarts(std::vector<RobustnessCase>& cases, const SceneCases& scenes) {
  for (const double amount : {0.1, 0.5, 2.0}) {
    cases.push_back({"starts",
                     fmt::format("egg_chair, shaken by {:g} spacings", amount),
                     scenes.design("egg_chair", {}),
                     {},
                     shake(amount)});
    cases.push_back({"starts",
                     fmt::format("strip, shaken by {:g} spacings", amount),
                     scenes.design("strip", {}),
                     {},
                     shake(amount)});
  }
}

void addSizes(std::vector<RobustnessCase>& cases, const SceneCases& scenes) {
  for (const int count : {35, 100, 200}) {
    cases.push_back(
        {"sizes", fmt::format("cup, {} nodes", count), scenes.design("cup", {nodes(count)}, 0.35)});
  }
}

void addRandomPatches(std::vector<RobustnessCase>& cases) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    cases.push_back(
        {"patches", fmt::format("random patch {}", seed), [seed] { return randomDesign(seed); }});
  }
}

}  // namespace

std::vector<RobustnessCase> listRobustnessCases(const std::filesystem::path& folder) {
  const SceneCases scenes(folder);
  std::vector<RobustnessCase> cases;
  addWeights(cases, scenes);
  addLayerSpacings(cases, scenes);
  addLayerCounts(cases, scenes);
  addShapes(cases);
  addThin(cases, scenes);
  addStarts(cases, scenes);
  addSizes(cases, scenes);
  addRandomPatches(cases);
  return cases;
}

}  // namespace morphgrid
