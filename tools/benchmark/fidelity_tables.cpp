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

std::string percents(const ShapePercent& distance) {
  return fmt::format("{:.3f} / {:.3f}", distance.rms, distance.max);
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

std::string goal(const FidelityRun& run) { return meetsGoal(run) ? "met" : "missed"; }

std::string sceneRow(const std::string& name, const char* design, const FidelityRun& run) {
  const GridShape& shape = run.record.grid.shape;
  return fmt::format(
      "| {} | {} | {} x {} | {} | **{}** | {} | {} | {} | {} | {:.1f} | {} | {:.1f} | {} |\n", name,
      design, shape.verticesU - 1, shape.verticesV - 1, distances(run),
      percents(run.frame.asDesigned), percents(run.frame.inexact), percents(run.frame.thicker),
      shrink(run), impossibleStruts(run), run.record.strain->largestPercent, steps(run),
      run.record.secondsTotal, goal(run));
}

std::string randomRow(const FidelityTrio& trio) {
  const FidelityRun& ours = trio.ours;
  return fmt::format("| {} | {} | {} | **{}** | {} | {} | {:.1f} | {} | {:.1f} | {} |\n", trio.name,
                     percents(trio.papers.frame.asDesigned),
                     percents(trio.springs.frame.asDesigned), percents(ours.frame.asDesigned),
                     shrink(ours), impossibleStruts(ours), ours.record.strain->largestPercent,
                     steps(ours), ours.record.secondsTotal, goal(ours));
}

double medianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::string medianRow(const std::vector<FidelityTrio>& trios) {
  const auto median = [&](const std::function<double(const FidelityTrio&)>& figure) {
    std::vector<double> values;
    std::transform(trios.begin(), trios.end(), std::back_inserter(values), figure);
    return medianOf(std::move(values));
  };
  const auto distance = [&](FidelityRun FidelityTrio::*run) {
    return percents({median([&](const FidelityTrio& t) { return (t.*run).frame.asDesigned.rms; }),
                     median([&](const FidelityTrio& t) { return (t.*run).frame.asDesigned.max; })});
  };
  const auto met = std::count_if(trios.begin(), trios.end(),
                                 [](const FidelityTrio& trio) { return meetsGoal(trio.ours); });
  return fmt::format(
      "| median | {} | {} | **{}** | {:.1f} | | {:.1f} | | {:.1f} | {} of {} |\n",
      distance(&FidelityTrio::papers), distance(&FidelityTrio::springs),
      distance(&FidelityTrio::ours),
      median([](const FidelityTrio& t) { return t.ours.record.shrink->largestPercent; }),
      median([](const FidelityTrio& t) { return t.ours.record.strain->largestPercent; }),
      median([](const FidelityTrio& t) { return t.ours.record.secondsTotal; }), met, trios.size());
}

}  // namespace

std::string sceneTable(const std::vector<FidelityTrio>& trios) {
  std::string text =
      "| scene | design | nodes | in its own model | in the frame | lengths off by 2 % | bars 25 % "
      "thicker | largest shrink (allowed) | over / growing | strain | steps | seconds | goal |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const FidelityTrio& trio : trios) {
    text += sceneRow(trio.name, "paper's", trio.papers) + sceneRow("", "springs'", trio.springs) +
            sceneRow("", "ours", trio.ours);
  }
  return text;
}

std::string randomTable(const std::vector<FidelityTrio>& trios) {
  std::string text =
      "| patch | paper's | springs' | ours | largest shrink (allowed) | over / growing | strain | "
      "steps | seconds | goal |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const FidelityTrio& trio : trios) {
    text += randomRow(trio);
  }
  return text + medianRow(trios);
}

std::string describe(const FidelityRun& run) {
  return fmt::format(
      "RMS / max in its own model {} %, in the frame {} %, shrink {} %, over / growing {}, {:.1f} "
      "s",
      distances(run), percents(run.frame.asDesigned), shrink(run), impossibleStruts(run),
      run.record.secondsTotal);
}

}  // namespace morphgrid
