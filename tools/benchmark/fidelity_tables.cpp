#include "benchmark/fidelity_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace morphgrid {
namespace {

std::string distances(const FidelityRun& run) {
  return fmt::format("{:.3f} / {:.3f}", run.record.distance->rmsPercent,
                     run.record.distance->maxPercent);
}

std::string closestPoints(const FidelityRun& run) {
  return fmt::format("{:.3f} / {:.3f}", run.record.distance->closestPointRmsPercent,
                     run.record.distance->closestPointMaxPercent);
}

std::string strutErrors(const FidelityRun& run) {
  const StrutErrors& e = *run.record.errors;
  return fmt::format("{:.2f} / {:.2f} / {:.2f}", e.l0Percent, e.lbPercent, e.anglePercent);
}

std::string shrink(const FidelityRun& run) {
  return fmt::format("{:.1f} ({:g})", run.record.shrink->largestPercent, 100 * run.maxShrinkage);
}

std::string impossibleStruts(const FidelityRun& run) {
  return fmt::format("{} / {}", run.record.shrink->strutsOverLimit,
                     run.record.shrink->strutsGrowing);
}

/// Rounds of compensation and steps of optimisation.
std::string steps(const FidelityRun& run) {
  if (!run.record.inverse) {
    return "";
  }
  const auto countOf = [&](InverseStep::Kind kind) {
    return std::count_if(run.record.inverse->steps.begin(), run.record.inverse->steps.end(),
                         [&](const InverseStep& step) { return step.kind == kind; });
  };
  return fmt::format("{} + {}", countOf(InverseStep::Kind::compensate),
                     countOf(InverseStep::Kind::optimise));
}

/// Where a slow morph from the printed sheet ends.
std::string fromFlat(const FidelityRun& run) {
  if (!run.record.inverse || !run.record.inverse->fromFlat) {
    return "";
  }
  const FromFlat& end = *run.record.inverse->fromFlat;
  return end.sameEquilibrium ? "there" : fmt::format("elsewhere: {:.3f}", end.rmsPercent);
}

std::string goal(const FidelityRun& run) { return meetsGoal(run) ? "met" : "missed"; }

std::string sceneRow(const std::string& name, const char* design, const FidelityRun& run) {
  const GridShape& shape = run.record.grid.shape;
  return fmt::format(
      "| {} | {} | {} x {} | {} | {} | {} | {} | {} | {:.2f} | {} | {} | {:.1f} | {} |\n", name,
      design, shape.verticesU - 1, shape.verticesV - 1, distances(run), closestPoints(run),
      strutErrors(run), shrink(run), impossibleStruts(run), run.record.printScale, steps(run),
      fromFlat(run), run.record.secondsTotal, goal(run));
}

std::string randomRow(const FidelityPair& pair) {
  const FidelityRun& ours = pair.ours;
  return fmt::format("| {} | {} | {} | {} | {} | {} | {:.2f} | {} | {} | {:.1f} | {} |\n",
                     pair.name, distances(pair.papers), impossibleStruts(pair.papers),
                     distances(ours), shrink(ours), impossibleStruts(ours), ours.record.printScale,
                     steps(ours), fromFlat(ours), ours.record.secondsTotal, goal(ours));
}

double medianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::string medianRow(const std::vector<FidelityPair>& pairs) {
  const auto median = [&](const std::function<double(const FidelityPair&)>& figure) {
    std::vector<double> values;
    std::transform(pairs.begin(), pairs.end(), std::back_inserter(values), figure);
    return medianOf(std::move(values));
  };
  const auto met = std::count_if(pairs.begin(), pairs.end(),
                                 [](const FidelityPair& pair) { return meetsGoal(pair.ours); });
  const auto distance = [](const FidelityRun& run) { return *run.record.distance; };
  return fmt::format(
      "| median | {:.3f} / {:.3f} | | {:.3f} / {:.3f} | {:.1f} | | {:.2f} | | | {:.1f} | {} of {} "
      "|\n",
      median([&](const FidelityPair& p) { return distance(p.papers).rmsPercent; }),
      median([&](const FidelityPair& p) { return distance(p.papers).maxPercent; }),
      median([&](const FidelityPair& p) { return distance(p.ours).rmsPercent; }),
      median([&](const FidelityPair& p) { return distance(p.ours).maxPercent; }),
      median([](const FidelityPair& p) { return p.ours.record.shrink->largestPercent; }),
      median([](const FidelityPair& p) { return p.ours.record.printScale; }),
      median([](const FidelityPair& p) { return p.ours.record.secondsTotal; }), met, pairs.size());
}

}  // namespace

std::string sceneTable(const std::vector<FidelityPair>& pairs) {
  std::string text =
      "| scene | design | nodes | RMS / max | to closest point | L0 / L_b / angle error | largest "
      "shrink (allowed) | over / growing | print scale | steps | from flat | seconds | goal |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const FidelityPair& pair : pairs) {
    text += sceneRow(pair.name, "paper's", pair.papers) + sceneRow("", "ours", pair.ours);
  }
  return text;
}

std::string randomTable(const std::vector<FidelityPair>& pairs) {
  std::string text =
      "| patch | paper's: RMS / max | over / growing | ours: RMS / max | largest shrink (allowed) "
      "| over / growing | print scale | steps | from flat | seconds | goal |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const FidelityPair& pair : pairs) {
    text += randomRow(pair);
  }
  return text + medianRow(pairs);
}

std::string describe(const FidelityRun& run) {
  return fmt::format("RMS / max {} %, shrink {} %, over / growing {}, {:.1f} s", distances(run),
                     shrink(run), impossibleStruts(run), run.record.secondsTotal);
}

}  // namespace morphgrid
