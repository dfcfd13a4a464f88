#include "print/print_tolerance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "print/html_text.h"

namespace morphgrid {
namespace {

std::string toleranceRow(const std::string& what, const std::string& figures) {
  return fmt::format("  {:<26}{}\n", what, figures);
}

/// ", 2 in another equilibrium", where there are such.
std::string asidesOf(int jumps, int unconverged) {
  std::string text;
  if (jumps > 0) text += fmt::format(", {} in another equilibrium", jumps);
  if (unconverged > 0) text += fmt::format(", {} not at rest", unconverged);
  return text;
}

std::string describe(const DisturbedPrint& print) {
  return fmt::format("{:.3g} / {:.3g} %{}", print.rmsPercent, print.maxPercent,
                     asidesOf(print.isJump ? 1 : 0, print.isConverged ? 0 : 1));
}

std::string describe(const DisturbedPrints& kind) {
  const DisturbedFigures figures = figuresOf(kind.prints);
  return fmt::format("{:.3g} / {:.3g} / {:.3g} %{}", figures.meanRms, figures.rms95,
                     figures.meanMax, asidesOf(figures.jumps, figures.unconverged));
}

std::string describe(const ToleranceLever& lever) {
  const std::string slope =
      lever.firstOrder ? fmt::format(" (to first order {:+.2g})", *lever.firstOrder) : "";
  return fmt::format("{:+.2g} if it shrinks more{}, {:+.2g} if less; the layer moves by {:.2g} %",
                     lever.more, slope, lever.less, lever.movement);
}

std::string whatJudged(const PrintTolerance& tolerance) {
  return fmt::format("distance {}, % RMS / most, by the model {}",
                     tolerance.hasTarget ? "to the target" : "to where the design ends",
                     tolerance.model);
}

/// A scale from 0 to `most` with a mark for each print, and a long one at the mean.
std::string marksOf(const DisturbedPrints& kind, double most) {
  constexpr double kWidth = 120, kHeight = 6;  // mm
  const auto mark = [&](double rms, double from, double width) {
    const double x = most > 0 ? kWidth * rms / most : 0;
    return fmt::format(
        "<line x1=\"{0:.2f}\" x2=\"{0:.2f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#000\" "
        "stroke-width=\"{3}\"/>",
        x, from, kHeight, width);
  };
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 "
      "{0} {1}\"><line x1=\"0\" x2=\"{0}\" y1=\"{1}\" y2=\"{1}\" stroke=\"#888\" "
      "stroke-width=\"0.4\"/>",
      kWidth, kHeight);
  for (const DisturbedPrint& print : kind.prints) text += mark(print.rmsPercent, 3, 0.2);
  return text + mark(figuresOf(kind.prints).meanRms, 0, 0.6) + "</svg>";
}

}  // namespace

double quantileOf(std::vector<double> values, double quantile) {
  std::sort(values.begin(), values.end());
  const double at = quantile * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(at);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (at - static_cast<double>(low)) * (values[high] - values[low]);
}

DisturbedFigures figuresOf(const std::vector<DisturbedPrint>& prints) {
  DisturbedFigures figures;
  std::vector<double> rms;
  const auto count = static_cast<double>(prints.size());
  for (const DisturbedPrint& print : prints) {
    rms.push_back(print.rmsPercent);
    figures.meanRms += print.rmsPercent / count;
    figures.meanMax += print.maxPercent / count;
    figures.jumps += print.isJump ? 1 : 0;
    figures.unconverged += print.isConverged ? 0 : 1;
  }
  figures.rms95 = quantileOf(std::move(rms), 0.95);
  return figures;
}

std::string toleranceTable(const PrintTolerance& tolerance) {
  const ToleranceRequest& request = tolerance.request;
  const double percent = 100 * request.share;
  std::string text =
      toleranceRow(fmt::format("shrinks off by {:g} %", percent), whatJudged(tolerance));
  text += toleranceRow("  none", describe(tolerance.undisturbed));
  text += toleranceRow("  all less", describe(tolerance.shrinksLess));
  text += toleranceRow("  all more", describe(tolerance.shrinksMore));
  text += toleranceRow(fmt::format("  {} random prints each", request.samples),
                       fmt::format("RMS mean / 95 % / most, mean; one sigma {:g} %, seed {}",
                                   percent, request.seed));
  for (const DisturbedPrints& kind : tolerance.kinds) {
    text += toleranceRow("    " + kind.what, describe(kind));
  }
  text += toleranceRow("  what matters most", "change of the distance (RMS), in percentage points");
  for (const auto* levers : {&tolerance.tiers, &tolerance.struts}) {
    for (const ToleranceLever& lever : *levers) {
      text += toleranceRow("    " + lever.what, describe(lever));
    }
  }
  return text;
}

std::string tolerancePage(const PrintTolerance& tolerance) {
  double most = tolerance.undisturbed.rmsPercent;
  for (const DisturbedPrints& kind : tolerance.kinds) {
    for (const DisturbedPrint& print : kind.prints) most = std::max(most, print.rmsPercent);
  }
  std::string rows;
  const auto row = [&](const std::string& what, const std::string& figures,
                       const std::string& marks) {
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", htmlText(what),
                        htmlText(figures), marks);
  };
  row("none", describe(tolerance.undisturbed), "");
  row("all less", describe(tolerance.shrinksLess), "");
  row("all more", describe(tolerance.shrinksMore), "");
  for (const DisturbedPrints& kind : tolerance.kinds) {
    row(kind.what, describe(kind), marksOf(kind, most));
  }
  for (const auto* levers : {&tolerance.tiers, &tolerance.struts}) {
    for (const ToleranceLever& lever : *levers) row(lever.what, describe(lever), "");
  }
  return fmt::format(
      "<h2>When shrinks are off by {:g} %</h2>\n<p>{}; of {} random prints each: RMS mean, 95 %, "
      "mean of the largest. Marks: each print, from 0 to {:.3g} %.</p>\n<table>\n{}</table>\n",
      100 * tolerance.request.share, whatJudged(tolerance), tolerance.request.samples, most, rows);
}

std::vector<std::string> toleranceNotices(const PrintTolerance& tolerance) {
  int jumps = 0;
  int prints = 0;
  for (const DisturbedPrints& kind : tolerance.kinds) {
    const DisturbedFigures figures = figuresOf(kind.prints);
    jumps += figures.jumps;
    prints += static_cast<int>(kind.prints.size());
  }
  if (jumps == 0) return {};
  return {
      fmt::format("{} of {} prints with errors of {:g} % come to rest in another equilibrium: "
                  "the shape can tip",
                  jumps, prints, 100 * tolerance.request.share)};
}

}  // namespace morphgrid
