#include "benchmark/random_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <random>

#include "app/simulate_scene.h"
#include "core/error.h"
#include "core/interrupt.h"
#include "energy/strut_energy.h"
#include "solve/energy_left.h"
#include "solve/reference_solver.h"

namespace morphgrid {
namespace {

constexpr unsigned kRandomSeeds = 100;
constexpr std::array kMethods = {Method::multigrid, Method::jacobi, Method::reference};
// More sweeps or iterations than that are not waited for; multigrid takes tens.
constexpr long kMostIterations = 20000;
constexpr long kDownhillSteps = 400;
// Shares of the energy.
constexpr double kFalseEnd = 1e-6;
constexpr double kOneEnergy = 1e-5;

/// Draws numbers.
class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}

  double evenly(double least, double most) {
    return least + (most - least) * (random_() / static_cast<double>(std::mt19937::max()));
  }
  double overDecades(double least, double most) {
    return std::pow(10, evenly(std::log10(least), std::log10(most)));
  }
  int count(int least, int most) {
    return least + static_cast<int>(random_() % static_cast<unsigned>(most - least + 1));
  }

 private:
  std::mt19937 random_;
};

struct PatchKind {
  const char* name;
  double height;  ///< How far control points lie out of the plane, of 10 units of extent.
  double jitter;  ///< In the plane.
};
constexpr std::array kPatchKinds = {PatchKind{"flat", 1e-4, 0.5}, PatchKind{"mild", 1, 0.5},
                                    PatchKind{"strong", 4, 1}, PatchKind{"folded", 8, 3}};

RandomSceneResult describe(unsigned seed, Scene& scene) {
  Dice dice(seed);
  const PatchKind& kind = kPatchKinds[seed % kPatchKinds.size()];
  PatchRequest patch;
  const double stretch = dice.evenly(0.5, 2);
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      const double x = 10 * static_cast<double>(i) / 3 + dice.evenly(-kind.jitter, kind.jitter);
      const double y =
          10 * stretch * static_cast<double>(j) / 3 + dice.evenly(-kind.jitter, kind.jitter);
      patch.controlPoints[j][i] = {x, y, dice.evenly(-kind.height, kind.height)};
    }
  }
  scene.surface = patch;
  scene.design.nodesLong = dice.count(5, 9);
  scene.design.layers = dice.count(2, 5);
  scene.design.layerSpacing =
      dice.evenly(0.1, 0.8) * 10 * std::max(1.0, stretch) / scene.design.nodesLong;
  scene.design.net = dice.count(0, 1) == 0 ? NetKind::isoline : NetKind::orthogonal;
  for (double* weight : {&scene.weights.lateral, &scene.weights.vertical, &scene.weights.angle}) {
    *weight = dice.overDecades(1e-3, 1e3);
  }
  return {
      seed,
      fmt::format("{}, {}, {} layers", kind.name, nameOf(scene.design.net), scene.design.layers),
      scene.weights,
      {},
      {}};
}

MethodEnd endBy(Method method, Scene scene, const SceneDesign& designed,
                const std::shared_ptr<Device>& device) {
  scene.method = method;
  scene.solve.iterationLimit = kMostIterations;
  RunContext context{.device = device};
  CheckpointKeeper keeper({}, {});
  Simulation simulation = simulateScene(scene, designed, context, keeper, true);
  const Equilibrium& found = simulation.stage.equilibrium;
  MethodEnd end{method, found.converged && simulation.record.inPlane->converged,
                context.failure.value_or(toString(found.reason)), found.energy};
  if (!found.positions.allFinite()) return end;
  StrutGrid grid = simulation.stage.grid;
  grid.positions = found.positions;
  const Equilibrium downhill =
      solveReference(grid, {.tolerance = 1e-12, .iterationLimit = kDownhillSteps});
  const double none = grid.spacing * grid.spacing *
                      negligibleEnergy(StrutEnergy(grid).meanStiffness(), grid.shape.vertexCount());
  end.excess = (found.energy - downhill.energy) / std::max(found.energy, none);
  return end;
}

RandomSceneResult solveRandomScene(unsigned seed, const std::shared_ptr<Device>& device) {
  Scene scene{.name = fmt::format("seed_{}", seed)};
  RandomSceneResult result = describe(seed, scene);
  try {
    const SceneDesign designed = designScene(scene);
    for (const Method method : kMethods) {
      result.ends.push_back(endBy(method, scene, designed, device));
    }
  } catch (const InputError& error) {
    result.refusal = error.what();
  }
  return result;
}

double largestEnergyGap(const RandomSceneResult& result) {
  const auto [least, most] = std::ranges::minmax(result.ends, {}, &MethodEnd::energy);
  return most.energy > 0 ? 1 - least.energy / most.energy : 0;
}

bool allConverged(const RandomSceneResult& result) {
  return std::ranges::all_of(result.ends, &MethodEnd::converged) && !result.ends.empty();
}

constexpr const char* kRandomHead =
    "| seed | scene | lateral / vertical / angle | multigrid | jacobi | reference |\n"
    "| --- | --- | --- | --- | --- | --- |\n";

std::string toCell(const MethodEnd& end) {
  const std::string text =
      fmt::format("{:.6g}, {} ({:.0e})", end.energy, end.ending, std::max(0.0, end.excess));
  return end.isFalse() || !end.isFinite() ? "**" + text + "**" : text;
}

std::string toRow(const RandomSceneResult& result) {
  std::string row =
      fmt::format("| {} | {} | {:.2g} / {:.2g} / {:.2g} |", result.seed, result.kind,
                  result.weights.lateral, result.weights.vertical, result.weights.angle);
  for (const MethodEnd& end : result.ends) row += fmt::format(" {} |", toCell(end));
  return row + "\n";
}

bool isTold(const RandomSceneResult& result) { return !result.refusal && !result.isAgreed(); }

std::string countsOf(const std::vector<RandomSceneResult>& results) {
  const auto count = [&](auto suits) { return std::ranges::count_if(results, suits); };
  std::string text = fmt::format(
      "{} scenes, {} refused by the design; all methods converged to one energy (within {:g}) on "
      "{}, each to an equilibrium but not\nto one on {}; on {} not all converged, and said so.\n\n"
      "| method | converged | not, and says so | false ends | no numbers |\n"
      "| --- | --- | --- | --- | --- |\n",
      results.size(), count([](const auto& r) { return r.refusal.has_value(); }), kOneEnergy,
      count([](const auto& r) { return r.isAgreed(); }),
      count([](const auto& r) { return r.hasSeveralEquilibria(); }),
      count([](const auto& r) { return !r.refusal && !allConverged(r); }));
  for (std::size_t n = 0; n < kMethods.size(); ++n) {
    const auto countEnds = [&](auto suits) {
      return count([&](const auto& r) { return !r.refusal && suits(r.ends[n]); });
    };
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", nameOf(kMethods[n]),
                        countEnds([](const MethodEnd& e) { return e.converged; }),
                        countEnds([](const MethodEnd& e) { return !e.converged; }),
                        countEnds([](const MethodEnd& e) { return e.isFalse(); }),
                        countEnds([](const MethodEnd& e) { return !e.isFinite(); }));
  }
  return text;
}

}  // namespace

bool MethodEnd::isFinite() const { return std::isfinite(energy) && std::isfinite(excess); }

bool MethodEnd::isFalse() const { return converged && !(excess <= kFalseEnd); }

bool RandomSceneResult::isAgreed() const {
  return allConverged(*this) && largestEnergyGap(*this) <= kOneEnergy;
}

bool RandomSceneResult::hasSeveralEquilibria() const {
  return allConverged(*this) && !isAgreed() && std::ranges::none_of(ends, &MethodEnd::isFalse);
}

std::vector<RandomSceneResult> measureRandomScenes(const std::shared_ptr<Device>& device,
                                                   const std::string& only) {
  std::vector<RandomSceneResult> results;
  for (unsigned seed = 1; seed <= kRandomSeeds && !interruptRequested(); ++seed) {
    if (fmt::format("random: seed {}", seed).find(only) == std::string::npos) continue;
    if (results.empty()) fmt::print("\n{}", kRandomHead);
    results.push_back(solveRandomScene(seed, device));
    if (isTold(results.back())) {
      fmt::print("{}", toRow(results.back()));
      std::cout.flush();
    }
  }
  if (!results.empty()) fmt::print("\n{}", countsOf(results));
  return results;
}

std::string toMarkdown(const std::vector<RandomSceneResult>& results) {
  std::string text = fmt::format(
      "Patches of random control points, flat to folded, 5 to 9 nodes, 2 to 5 layers, each weight "
      "anywhere from 0.001 to 1000, solved by\n"
      "all methods, at most {} iterations each. *False end*: a method says that it has converged, "
      "and in double precision the energy\n"
      "falls further by more than {:g} of it in {} steps of `reference` from there (the figure in "
      "brackets). Rows: where the methods do not\n"
      "all converge to one energy.\n\n",
      kMostIterations, kFalseEnd, kDownhillSteps);
  text += countsOf(results) + "\n" + kRandomHead;
  for (const RandomSceneResult& result : results) {
    if (isTold(result)) text += toRow(result);
  }
  return text;
}

}  // namespace morphgrid
