#include "benchmark/solve_report.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "benchmark/targets.h"
#include "report/plot.h"

namespace morphgrid {
namespace {

constexpr double kSmallSize = 25000;  // Vertices with which cost per vertex is compared.

std::string secondsText(double seconds) { return fmt::format("{:.3g}", seconds); }

std::string describeMethod(const MethodRuns& one, double leastEnergy) {
  const auto arrival = one.arrival(leastEnergy);
  return fmt::format("  {:<10} {:>9} {:>7}   {:>9} {:>9} {:>10} {:>14.8g}  {}{}\n", one.method,
                     arrival ? secondsText(arrival->seconds) : "-",
                     arrival ? fmt::format("{}", arrival->iterations) : "-",
                     secondsText(one.wallSeconds()), secondsText(one.cpuSeconds()),
                     one.runs.front().iterations(), one.energy(), one.runs.front().ending,
                     one.runs.size() == 1 ? ", one run" : "");
}

std::string describeInPlane(const std::vector<MethodRuns>& methods) {
  std::string text = "  in plane, to the method's own stop:";
  for (const MethodRuns& one : methods) {
    text += fmt::format(" {} {} s{}{}", one.method, secondsText(one.wallSeconds()),
                        one.converged() ? "" : " (" + one.runs.front().ending + ")",
                        &one == &methods.back() ? "\n" : ",");
  }
  return text;
}

/// atMost: the value may be less than it seems.
std::string describeBounds(const char* what, double value, const Bounds& bounds,
                           bool atMost = false) {
  const char* verdict = value <= bounds.aim    ? "as aimed at"
                        : value <= bounds.must ? "as it must be"
                        : atMost               ? "not known, --peer-seconds was too short"
                                               : "MISSED";
  return fmt::format("  {}: {}{:.3g} (must be {:.3g}, aim {:.3g}): {}\n", what,
                     atMost ? "at most " : "", value, bounds.must, bounds.aim, verdict);
}

/// The time to the energy, or at least how long it was tried.
double secondsOf(const MethodRuns& one, double leastEnergy) {
  const auto arrival = one.arrival(leastEnergy);
  return arrival ? arrival->seconds : one.wallSeconds();
}

/// Multigrid's time as a share of `method`'s; a peer that was cut short took longer than what is
/// counted.
std::optional<double> shareOf(const Comparison& comparison, const std::string& method) {
  const MethodRuns* multigrid = comparison.find("multigrid");
  const MethodRuns* peer = comparison.find(method);
  const double energy = comparison.leastEnergy();
  if (!multigrid || !peer || !multigrid->arrival(energy)) {
    return std::nullopt;
  }
  return secondsOf(*multigrid, energy) / secondsOf(*peer, energy);
}

std::string describeShares(const Comparison& comparison) {
  std::string text;
  for (const MethodRuns& peer : comparison.full) {
    const auto share = shareOf(comparison, peer.method);
    if (peer.method != "multigrid" && share) {
      text += fmt::format("  multigrid is {:.3g} times as fast as {}{}\n", 1 / *share, peer.method,
                          peer.arrival(comparison.leastEnergy()) ? "" : ", or more");
    }
  }
  return text;
}

std::string describeTargets(const Comparison& comparison) {
  const MethodRuns* multigrid = comparison.find("multigrid");
  if (!multigrid) {
    return {};
  }
  const SolveTarget target = targetOf(comparison.name);
  const auto arrival = multigrid->arrival(comparison.leastEnergy());
  if (!arrival) {
    return "  multigrid does not reach the energy: MISSED\n";
  }
  std::string text;
  if (target.seconds) {
    text += describeBounds("seconds", arrival->seconds, *target.seconds);
  }
  const auto share = shareOf(comparison, "reference");
  if (target.shareOfReference && share) {
    const bool cutShort = !comparison.find("reference")->arrival(comparison.leastEnergy());
    text += describeBounds("share of reference's time", *share, *target.shareOfReference, cutShort);
  }
  if (target.cycles) {
    text += describeBounds("V-cycles", static_cast<double>(arrival->iterations), *target.cycles);
  }
  return text;
}

double bytesPerVertex(const Comparison& comparison) {
  const MethodRuns* multigrid = comparison.find("multigrid");
  return multigrid ? static_cast<double>(multigrid->runs.front().deviceBytes) /
                         comparison.shape.vertexCount()
                   : 0;
}

std::string describeMemory(const Comparison& comparison) {
  const double bytes = bytesPerVertex(comparison);
  if (bytes == 0) {
    return {};
  }
  const bool bounded =
      comparison.shape.layers == 3 && comparison.shape.vertexCount() >= kFewestBoundedVertices;
  return fmt::format("  device memory of multigrid: {:.0f} bytes a vertex{}{}\n", bytes,
                     bounded ? fmt::format(" (at most {:.0f})", kMostBytesPerVertex) : "",
                     bounded && bytes > kMostBytesPerVertex ? ": MISSED" : "");
}

/// Nanoseconds per vertex of a solve by multigrid, to its own stop.
struct CostPerVertex {
  double wall;
  double cpu;
  double cycles;
};

CostPerVertex costPerVertex(const Comparison& comparison) {
  const MethodRuns& multigrid = *comparison.find("multigrid");
  const double toNanoseconds = 1e9 / comparison.shape.vertexCount();
  return {toNanoseconds * multigrid.wallSeconds(), toNanoseconds * multigrid.cpuSeconds(),
          static_cast<double>(multigrid.runs.front().iterations())};
}

std::string describeGrowth(const char* what, double small, double large) {
  return fmt::format("  {:<26} {:>10.0f} {:>10.0f} {:>8.2f}\n", what, small, large, large / small);
}

nlohmann::json toJson(const MethodRuns& one, double leastEnergy) {
  nlohmann::json json{{"method", one.method},
                      {"wall_seconds", one.wallSeconds()},
                      {"cpu_seconds", one.cpuSeconds()},
                      {"iterations", one.runs.front().iterations()},
                      {"ending", one.runs.front().ending},
                      {"runs", one.runs.size()}};
  if (std::isfinite(one.energy())) {
    json["energy"] = one.energy();
  }
  if (const auto arrival = one.arrival(leastEnergy)) {
    json["seconds_to_energy"] = arrival->seconds;
    json["iterations_to_energy"] = arrival->iterations;
  }
  for (const ConvergenceSample& sample : one.runs.front().history) {
    json["history"].push_back({{"iteration", sample.iteration},
                               {"energy", sample.energy},
                               {"seconds", one.runs.front().untilSolve + sample.seconds}});
  }
  return json;
}

}  // namespace

std::string describe(const Comparison& comparison) {
  const GridShape& shape = comparison.shape;
  std::string text =
      fmt::format("{}: {} x {} x {} = {} vertices\n", comparison.name, shape.verticesU,
                  shape.verticesV, shape.layers, shape.vertexCount());
  text += describeInPlane(comparison.inPlane);
  text += fmt::format("  {:<10} {:>17}   {:>9} {:>9} {:>10}\n", "full stage", "to the energy",
                      "stop", "stop", "stop");
  text += fmt::format("  {:<10} {:>9} {:>7}   {:>9} {:>9} {:>10} {:>14}  {}\n", "", "wall s",
                      "iter.", "wall s", "CPU s", "iter.", "energy", "end");
  for (const MethodRuns& one : comparison.full) {
    text += describeMethod(one, comparison.leastEnergy());
  }
  return text + describeShares(comparison) + describeTargets(comparison) +
         describeMemory(comparison);
}

std::string describeGrowth(const std::vector<Comparison>& comparisons) {
  const Comparison* small = nullptr;
  const Comparison* large = nullptr;
  const auto distance = [](const Comparison& one) {
    return std::abs(std::log(one.shape.vertexCount() / kSmallSize));
  };
  for (const Comparison& one : comparisons) {
    if (one.shape.layers != 3 || !one.find("multigrid")) {
      continue;
    }
    small = !small || distance(one) < distance(*small) ? &one : small;
    large = !large || one.shape.vertexCount() > large->shape.vertexCount() ? &one : large;
  }
  if (small == large) {
    return {};
  }
  const CostPerVertex few = costPerVertex(*small);
  const CostPerVertex many = costPerVertex(*large);
  return fmt::format("multigrid, ns per vertex: {:>15} {:>10}    ratio (must be {})\n", small->name,
                     large->name, kLargestGrowth) +
         describeGrowth("a V-cycle, wall time", few.wall / few.cycles, many.wall / many.cycles) +
         describeGrowth("a V-cycle, CPU time", few.cpu / few.cycles, many.cpu / many.cycles) +
         describeGrowth("the full stage, wall time", few.wall, many.wall) +
         describeGrowth("the full stage, CPU time", few.cpu, many.cpu);
}

nlohmann::json toJson(const Comparison& comparison) {
  nlohmann::json json{{"name", comparison.name},
                      {"vertices", comparison.shape.vertexCount()},
                      {"layers", comparison.shape.layers},
                      {"device_bytes_per_vertex", bytesPerVertex(comparison)}};
  const double energy = comparison.leastEnergy();
  for (const MethodRuns& one : comparison.inPlane) {
    json["in_plane"].push_back(toJson(one, one.energy()));
  }
  for (const MethodRuns& one : comparison.full) {
    json["full"].push_back(toJson(one, energy));
  }
  return json;
}

std::string drawTimes(const std::vector<Comparison>& comparisons) {
  std::map<std::string, std::vector<PlotPoint>> points;
  for (const Comparison& comparison : comparisons) {
    const double energy = comparison.leastEnergy();
    for (const MethodRuns& one : comparison.full) {
      points[one.method].push_back({static_cast<double>(comparison.shape.vertexCount()),
                                    secondsOf(one, energy), !one.arrival(energy)});
    }
  }
  PlotPanel panel{"seconds", PlotScale::logarithmic, {}};
  for (auto& [method, all] : points) {
    panel.series.push_back({method, std::move(all)});
  }
  return toSvg({"From flat to equilibrium (energy within 1e-6)",
                "vertices",
                PlotScale::logarithmic,
                {std::move(panel)}});
}

}  // namespace morphgrid
