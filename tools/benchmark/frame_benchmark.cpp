#include "benchmark/frame_benchmark.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "benchmark/problem.h"
#include "benchmark/solve_comparison.h"
#include "core/atomic_file.h"
#include "core/read_file.h"
#include "design/material.h"
#include "report/generated_block.h"

namespace morphgrid {
namespace {

/// Bars' width over the mean lateral rest length.
constexpr double kSlenderness = 0.25;
/// Larger cups share the compiled kernels of this one.
constexpr int kMostWarmUpNodes = 100;

struct FrameBenchmark {
  std::vector<int> cups{20, 100, 630};
  ComparisonOptions comparison{.rounds = 5, .seconds = 30, .peerLimit = 120};
  std::string device;
  std::string document;
};

/// The same cup, flat.
struct CupGrids {
  StrutGrid springs;
  StrutGrid welded;  ///< The same sheet, its struts welded bars.
  StrutGrid frame;   ///< On the sheet that is laid out for bars.
};

StrutGrid asBars(StrutGrid grid) {
  double sum = 0;
  forEachLateralStrut(grid.shape, [&](const Strut& strut) { sum += valueAt(grid.rest, strut); });
  const double width = kSlenderness * sum / grid.shape.lateralStrutCount();
  applyMaterial(grid, {.model = Model::frame, .barWidth = width});
  return grid;
}

CupGrids cupGrids(const Device& device, int nodes) {
  const Problem problem = cupProblem(nodes);
  const StrutGrid springs = problem.stacked(runMultigrid(device, problem.inPlane()).positions);
  const Problem welded = weldedCupProblem(nodes);
  Eigen::Matrix3Xd sheet = Eigen::Matrix3Xd::Zero(3, welded.sheet->positions.cols());
  sheet.topRows<2>() = welded.sheet->positions;
  return {springs, asBars(springs), asBars(welded.stacked(sheet))};
}

std::string rowOf(int vertices, const MethodRuns& one) {
  const SolveRun& first = one.runs.front();
  const auto iterations = static_cast<double>(std::max(1L, first.iterations()));
  const bool onDevice = first.deviceBytes > 0;
  const std::string figures =
      one.converged() ? fmt::format("{} | {:.3g} | {:.3g} | {:.0f}", first.iterations(),
                                    one.wallSeconds(), 1e3 * one.wallSeconds() / iterations,
                                    1e9 * one.cpuSeconds() / iterations / vertices)
                      : fmt::format("{}: {} after {:.3g} s | | |", first.iterations(), first.ending,
                                    one.wallSeconds());
  return fmt::format(
      "| {} | {} | {} | {} |\n", vertices, one.method, figures,
      onDevice ? fmt::format("{:.0f}", static_cast<double>(first.deviceBytes) / vertices) : "");
}

std::string measure(const Device& device, int nodes, const ComparisonOptions& options) {
  const CupGrids grids = cupGrids(device, nodes);
  const std::vector<Entrant> entrants{{"springs, `multigrid`", "multigrid", grids.springs},
                                      {"frame, `multigrid`", "multigrid", grids.frame},
                                      {"frame on the springs' sheet", "multigrid", grids.welded},
                                      {"frame, `reference`", "reference", grids.frame}};
  std::string rows;
  for (const MethodRuns& runs : takeTurns(device, entrants, options)) {
    rows += rowOf(grids.springs.shape.vertexCount(), runs);
  }
  return rows;
}

void run(const FrameBenchmark& options) {
  const Device device({.selection = options.device, .validation = false});
  if (!options.document.empty()) {  // Better now than after half an hour.
    withBlock(readFile(options.document), "frame", "");
  }
  std::string table =
      "| vertices | | cycles or steps | from flat, s | one, ms | one, CPU ns a vertex | device, "
      "bytes a vertex |\n| --- | --- | --- | --- | --- | --- | --- |\n";
  fmt::print("device: {}\nfrom flat to the method's own stop; medians\n{}", device.name(), table);
  for (const int nodes : options.cups) {
    const CupGrids warmUp = cupGrids(device, std::min(nodes, kMostWarmUpNodes));
    runMultigrid(device, warmUp.springs);
    runMultigrid(device, warmUp.frame);
    runMultigrid(device, warmUp.welded);
    const std::string rows = measure(device, nodes, options.comparison);
    fmt::print("{}", rows);
    std::cout.flush();
    table += rows;
  }
  if (!options.document.empty()) {
    writeFileAtomically(options.document, withBlock(readFile(options.document), "frame", table));
  }
}

}  // namespace

void addFrameBenchmark(CLI::App& app) {
  const auto options = std::make_shared<FrameBenchmark>();
  CLI::App* frame = app.add_subcommand(
      "frame", "Times whole solves of cups as frames of welded bars, beside springs.");
  frame->add_option("--cup", options->cups, "cups with so many nodes on the long edge")
      ->check(CLI::Range(4, 20000))
      ->capture_default_str();
  frame
      ->add_option("--rounds", options->comparison.rounds,
                   "solves of which the median counts; fewer where they take long")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  frame
      ->add_option("--peer-seconds", options->comparison.peerLimit,
                   "after which a solve by reference is cut short")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  frame->add_option("--document", options->document,
                    "whose table between the marks `frame` is written anew");
  frame->add_option("--device", options->device, "index or part of the name of a Vulkan device");
  frame->callback([options] { run(*options); });
}

}  // namespace morphgrid
