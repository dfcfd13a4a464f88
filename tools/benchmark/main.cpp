#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "benchmark/disturbed_runs.h"
#include "benchmark/fidelity.h"
#include "benchmark/frame_benchmark.h"
#include "benchmark/inputs.h"
#include "benchmark/machine_benchmark.h"
#include "benchmark/print_benchmark.h"
#include "benchmark/profile_benchmark.h"
#include "benchmark/ray_benchmark.h"
#include "benchmark/robustness.h"
#include "benchmark/run_benchmark.h"
#include "benchmark/solve_benchmark.h"
#include "benchmark/sweep_benchmark.h"
#include "benchmark/validation.h"
#include "core/error.h"
#include "core/interrupt.h"

namespace morphgrid {
namespace {

enum ExitCode { kMeasured = 0, kWrongUsage = 2, kNoDevice = 4, kInterrupted = 130 };

/// `solve` may be left out.
std::vector<std::string> completed(std::vector<std::string> arguments) {
  const bool named = !arguments.empty() && arguments.front().front() != '-';
  const bool help =
      !arguments.empty() && (arguments.front() == "-h" || arguments.front() == "--help");
  if (!named && !help) {
    arguments.insert(arguments.begin(), "solve");
  }
  return arguments;
}

int runBenchmark(std::vector<std::string> arguments) {
  CLI::App app("Measures how fast morphgrid is.", "tools/bench");
  app.require_subcommand(0, 1);
  addSolveBenchmark(app);
  addRunBenchmark(app);
  addProfileBenchmark(app);
  addFrameBenchmark(app);
  addMachineBenchmark(app);
  addSweepBenchmark(app);
  addRayBenchmark(app);
  addPrintBenchmark(app);
  addRobustnessTable(app);
  addDisturbedRuns(app);
  addFidelityTable(app);
  addValidation(app);
  addInputsTable(app);
  std::reverse(arguments.begin(), arguments.end());  // As CLI11 takes them.
  try {
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kMeasured : kWrongUsage;
  }
  return kMeasured;
}

}  // namespace
}  // namespace morphgrid

int main(int argc, char** argv) {
  try {
    return morphgrid::runBenchmark(morphgrid::completed({argv + 1, argv + argc}));
  } catch (const morphgrid::InputError& error) {
    std::cerr << "bench: " << error.what() << "\n";
    return morphgrid::kWrongUsage;
  } catch (const std::exception& error) {
    std::cerr << "bench: " << error.what() << "\n";
    return morphgrid::interruptRequested() ? morphgrid::kInterrupted : morphgrid::kNoDevice;
  }
}
