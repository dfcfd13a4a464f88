#include "benchmark/robustness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "benchmark/disturbed_runs.h"
#include "benchmark/robustness_cases.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/interrupt.h"
#include "energy/strut_energy.h"
#include "solve/multigrid_solver.h"
#include "solve/preconditioners.h"
#include "solve/reference_solver.h"

namespace morphgrid {
namespace {

constexpr long kCycleLimit = 2000;
constexpr double kEnergyError = 1e-6;
// How far the CPU follows the device's answer downhill, on grids so small that it is quick.
constexpr int kMostVerticesFollowed = 16000;
constexpr long kFollowingSteps = 400;
// The search for the smallest eigenvalue works on the CPU too, with a V-cycle a step.
constexpr int kMostVerticesJudged = 30000;
// In stiffness x spacing^2 a vertex: where a grid can come to rest without stress, its energy is
// compared with this one.
constexpr double kLittleEnergy = 1e-10;

struct Result {
  std::string group;
  std::string name;
  std::string ending;  ///< Why the solve ended, or could not begin.
  bool converged = false;
  bool refused = false;  ///< The design refused the grid.
  int vertices = 0;
  long cycles = 0;             ///< On the finest grid, or worth as much.
  long cyclesToMillionth = 0;  ///< Until the energy stays within 1e-6 of the lowest known.
  double energy = 0;
  double energyError = 0;  ///< Relative to the lowest known.
  double residual = 0;
  double seconds = 0;
  std::optional<SmallestEigenvalue> eigenvalue;  ///< Not of large grids.
};

Equilibrium solve(const Device& device, const StrutGrid& grid, DeviceGrid& deviceGrid) {
  return solveMultigrid(device, grid, deviceGrid, {.iterationLimit = kCycleLimit});
}

Equilibrium solve(const Device& device, const StrutGrid& grid) {
  DeviceGrid deviceGrid(device, grid);
  return solve(device, grid, deviceGrid);
}

/// The device grid rests in the equilibrium.
std::optional<SmallestEigenvalue> judge(const Device& device, const StrutGrid& grid,
                                        const DeviceGrid& deviceGrid, const Equilibrium& found) {
  if (grid.shape.vertexCount() > kMostVerticesJudged) {
    return std::nullopt;
  }
  return computeSmallestEigenvalue(grid, found.positions, vCyclePreconditioner(device, deviceGrid));
}

/// The device's answer or what the CPU finds downhill from it, in double precision.
double lowestEnergyNear(StrutGrid grid, const Equilibrium& found) {
  if (grid.shape.vertexCount() > kMostVerticesFollowed) {
    return found.energy;
  }
  grid.positions = found.positions;
  const Equilibrium followed =
      solveReference(grid, {.tolerance = 1e-11, .iterationLimit = kFollowingSteps});
  return std::min(found.energy, followed.energy);
}

/// What errors of the energy are compared with.
double energyScale(const StrutGrid& grid, double energy) {
  const double stiffness = 2 * StrutEnergy(grid).constraintWeights().sum();
  return std::max(energy, kLittleEnergy * stiffness * grid.spacing * grid.spacing);
}

/// Until the energy stays below a bound.
long cyclesTo(double energy, const std::vector<ConvergenceSample>& history) {
  long cycles = history.back().iteration;
  for (auto sample = history.rbegin(); sample != history.rend(); ++sample) {
    if (sample->gridShare < 1 || sample->energy > energy) {
      break;
    }
    cycles = sample->iteration;
  }
  return cycles;
}

void run(const Device& device, const RobustnessCase& testCase, Result& result) {
  const GridDesign design = testCase.design();
  const Equilibrium inPlane =
      solve(device, inPlaneGrid(design, testCase.weights, Scaling::normalised));
  StrutGrid grid = stackedGrid(design, testCase.weights, Scaling::normalised, inPlane.positions);
  if (testCase.disturb) {
    testCase.disturb(grid);
  }
  DeviceGrid deviceGrid(device, grid);
  const Equilibrium found = solve(device, grid, deviceGrid);
  const double lowest = lowestEnergyNear(grid, found);
  result.vertices = grid.shape.vertexCount();
  result.converged = inPlane.converged && found.converged;
  result.ending = toString(found.reason);
  if (!inPlane.converged) {
    result.ending += fmt::format("; in the plane: {}", toString(inPlane.reason));
  }
  result.cycles = found.iterations;
  const double scale = energyScale(grid, lowest);
  result.cyclesToMillionth = cyclesTo(lowest + kEnergyError * scale, found.history);
  result.energy = found.energy;
  result.energyError = (found.energy - lowest) / scale;
  result.residual = found.residual;
  result.seconds = found.seconds;
  result.eigenvalue = judge(device, grid, deviceGrid, found);
}

Result resultOf(const Device& device, const RobustnessCase& testCase) {
  Result result{testCase.group, testCase.name, {}};
  try {
    run(device, testCase, result);
  } catch (const InputError& error) {
    result.refused = true;
    result.ending = fmt::format("refused: {}", error.what());
  } catch (const DeviceError& error) {
    result.ending = fmt::format("failed: {}", error.what());
  }
  return result;
}

nlohmann::json toJson(const std::optional<SmallestEigenvalue>& eigenvalue) {
  if (!eigenvalue) {
    return nullptr;
  }
  return {{"value", eigenvalue->value},
          {"residual", eigenvalue->residual},
          {"iterations", eigenvalue->iterations},
          {"seconds", eigenvalue->seconds},
          {"verdict", toString(verdictOf(*eigenvalue))}};
}

nlohmann::json toJson(const Result& result) {
  return {{"group", result.group},
          {"case", result.name},
          {"ending", result.ending},
          {"converged", result.converged},
          {"refused", result.refused},
          {"vertices", result.vertices},
          {"cycles", result.cycles},
          {"cycles_to_1e-6", result.cyclesToMillionth},
          {"energy", result.energy},
          {"energy_error", result.energyError},
          {"residual", result.residual},
          {"seconds", result.seconds},
          {"smallest_eigenvalue", toJson(result.eigenvalue)}};
}

std::string toCell(const std::optional<SmallestEigenvalue>& eigenvalue) {
  if (!eigenvalue) {
    return "-";
  }
  const Verdict verdict = verdictOf(*eigenvalue);
  return verdict == Verdict::minimum
             ? fmt::format("{:.1e}", eigenvalue->value)
             : fmt::format("**{:.1e}, {}**", eigenvalue->value, toString(verdict));
}

std::string toRow(const Result& result) {
  if (result.vertices == 0) {
    return fmt::format("| {} | {} | | {} | | | | | | |\n", result.group, result.name,
                       result.ending);
  }
  return fmt::format("| {} | {} | {} | {} | {} | {} | {:.6g} | {:.1e} | {:.1e} | {} |\n",
                     result.group, result.name, result.vertices,
                     result.converged ? result.ending : "**" + result.ending + "**", result.cycles,
                     result.cyclesToMillionth, result.energy, result.energyError, result.residual,
                     toCell(result.eigenvalue));
}

constexpr const char* kTableHead =
    "| group | grid | vertices | ended by | cycles | to 1e-6 | energy | error | residual | "
    "eigenvalue |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";

/// How many came to rest in a minimum.
std::string summariseVerdicts(const std::vector<Result>& results) {
  const auto count = [&](Verdict verdict) {
    return std::count_if(results.begin(), results.end(), [&](const Result& result) {
      return result.eigenvalue && verdictOf(*result.eigenvalue) == verdict;
    });
  };
  return fmt::format("Minima: {}; saddles: {}; undecided: {}.\n", count(Verdict::minimum),
                     count(Verdict::saddle), count(Verdict::undecided));
}

/// How many converged, and where most cycles went.
std::string summarise(const std::vector<Result>& results) {
  int refused = 0;
  int converged = 0;
  const Result* longest = &results.front();
  for (const Result& result : results) {
    refused += result.refused;
    converged += result.converged;
    if (result.cycles > longest->cycles) {
      longest = &result;
    }
  }
  return fmt::format("{} of {} grids converged; {} more cannot be printed. Most cycles: {} ({}).\n",
                     converged, results.size() - refused, refused, longest->cycles, longest->name) +
         summariseVerdicts(results);
}

std::string toMarkdown(const std::string& deviceName, const std::vector<Result>& results) {
  std::string text = fmt::format(
      "# Robustness\n\n"
      "Written by `tools/robustness --markdown docs/robustness.md` on {}: grids of all sorts, "
      "solved from flat by\n"
      "`multigrid` at its default tolerances, at most {} cycles. A cycle on a coarser grid counts "
      "by its share of the\n"
      "vertices. *To 1e-6*: cycles until the energy stays within a millionth of the lowest known. "
      "*Error*: the energy\n"
      "found over the lowest known, less 1; that is what `reference` finds in double precision "
      "when it goes on\n"
      "downhill from there (up to {} steps, on grids of at most {} vertices), else the same. tau "
      "is in spacings; where\n"
      "Eq. 21 forbids it for the shrinkage the grid is made all the same, unless a strut would "
      "shrink to nothing.\n"
      "*Eigenvalue*: the smallest of the exact Hessian beyond the rigid motions, over the mean "
      "stiffness\n"
      "([method](method.md#minimum-or-saddle)): positive in a minimum, negative in a saddle, "
      "undecided where it stays\n"
      "within its residual in {} steps; a dash above {} vertices, where the search on the CPU "
      "takes long. With angle 0\n"
      "a strut that is compressed by ever so little has nothing else to hold it: a saddle.\n\n",
      deviceName, kCycleLimit, kFollowingSteps, kMostVerticesFollowed,
      EigenvalueOptions{}.iterationLimit, kMostVerticesJudged);
  text += summarise(results) + "\n" + kTableHead;
  for (const Result& result : results) {
    text += toRow(result);
  }
  return text;
}

struct RobustnessTable {
  std::string scenes = "scenes";
  std::string selection;
  std::string only;
  std::string jsonFile;
  std::string markdownFile;
};

std::vector<Result> measure(const Device& device, const RobustnessTable& options) {
  std::vector<Result> results;
  fmt::print("{}", kTableHead);
  for (const RobustnessCase& testCase : listRobustnessCases(options.scenes)) {
    if ((testCase.group + ": " + testCase.name).find(options.only) == std::string::npos) {
      continue;
    }
    results.push_back(resultOf(device, testCase));
    fmt::print("{}", toRow(results.back()));
    std::cout.flush();
    if (interruptRequested()) {
      throw std::runtime_error("interrupted");
    }
  }
  if (results.empty()) {
    throw InputError(fmt::format("--only {}: there is no such grid", options.only));
  }
  return results;
}

void run(const RobustnessTable& options) {
  installInterruptHandler();
  const Device device({.selection = options.selection, .validation = false});
  const std::vector<Result> results = measure(device, options);
  fmt::print("\n{}", summarise(results));
  if (!options.markdownFile.empty()) {
    writeFileAtomically(
        options.markdownFile,
        keepingDisturbedRuns(options.markdownFile, toMarkdown(device.name(), results)));
  }
  if (!options.jsonFile.empty()) {
    nlohmann::json rows = nlohmann::json::array();
    for (const Result& result : results) {
      rows.push_back(toJson(result));
    }
    writeFileAtomically(options.jsonFile,
                        nlohmann::json{{"device", device.name()}, {"grids", rows}}.dump(2));
  }
}

}  // namespace

void addRobustnessTable(CLI::App& app) {
  const auto options = std::make_shared<RobustnessTable>();
  CLI::App* robust = app.add_subcommand(
      "robust", "Solves grids of all sorts by multigrid and tells how each one ended.");
  robust->add_option("--scenes", options->scenes, "folder of the scene files")
      ->capture_default_str();
  robust->add_option("--only", options->only,
                     "only grids whose `group: name` contains this, e.g. thin:");
  robust->add_option("--device", options->selection,
                     "index or part of the name of a Vulkan device");
  robust->add_option("--json", options->jsonFile, "also write the figures to this file");
  robust->add_option("--markdown", options->markdownFile, "also write the table to this file");
  robust->callback([options] { run(*options); });
}

}  // namespace morphgrid
