#include "print/assembly_page.h"

#include <fmt/format.h>

#include "print/html_text.h"

namespace morphgrid {
namespace {

constexpr const char* kStyle =
    "<style>\nbody { font-family: sans-serif; max-width: 60em; margin: 1em auto; }\n"
    "figure { margin: 1em 0; break-inside: avoid; break-before: page; }\n"
    "td { padding: 0 1em 0 0; vertical-align: top; }\n@page { margin: 5mm; }\n</style>\n";

std::string partsTable(const PrintRecord& record) {
  std::string rows;
  for (std::size_t n = 0; n < record.tiers.size(); ++n) {
    const TierFigures& tier = record.tiers[n];
    rows += fmt::format("<tr><td>tier_{}.gcode</td><td>{:.1f} g</td><td>{:.1f} h</td></tr>\n",
                        n + 1, tier.grams, tier.seconds / 3600);
  }
  return "<table>\n" + rows + "</table>\n";
}

/// Pins are pressed flat at both ends, for which they stand out.
constexpr double kPinEnds = 4;  // mm, both together.

std::string assemblySteps(const PrintRecord& record) {
  const PrintPlan& plan = record.plan;
  std::string steps = fmt::format(
      "<li>Print the tiers from one spool, in one session, at one temperature: errors of single "
      "struts average out, those of a whole tier do not. The first pass is {:g} mm high: level the "
      "bed.</li>\n",
      plan.material.heightOf(0));
  if (plan.shape.layers > 1) {
    steps += fmt::format(
        "<li>Cut {} pins of {:.2f} mm, {:.0f} mm long.</li>\n"
        "<li>Stack the tiers, the first at the bottom, all with their numbers in the same corner "
        "and upright. Pin the four corners first, then from the middle outwards.</li>\n"
        "<li>Press the ends of the pins flat, hot (about 200 degrees C), over a washer.</li>\n",
        plan.shape.layerVertexCount(), plan.request.pin, stackHeight(plan) + kPinEnds);
  }
  return "<ol>\n" + steps +
         fmt::format(
             "<li>Snap the numbers off.</li>\n<li>Lay the grid into water of {:g} degrees "
             "C, above {:g}, until it no longer moves.</li>\n</ol>\n",
             plan.material.bath, plan.material.glassTransition);
}

}  // namespace

std::string assemblyPage(const PrintRecord& record) {
  const PrintPlan& plan = record.plan;
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>{0}: "
      "assembly</title>\n"
      "{1}<h1>{0}</h1>\n<p>{2}</p>\n<p>Printer: {3}. Material: {4} ({5}, {6}).<br>{7}.</p>\n",
      htmlText(plan.name), kStyle, htmlText(record.verdict.line()), htmlText(plan.printer.name),
      htmlText(plan.material.name), htmlText(plan.material.source), plan.material.year,
      htmlText(plan.material.caveat));
  for (const std::string& notice : printNotices(record)) {
    page += fmt::format("<p><b>{}</b></p>\n", htmlText(notice));
  }
  page += partsTable(record) + assemblySteps(record) +
          (record.tolerance ? tolerancePage(*record.tolerance) : "") +
          "<p>The maps are at 1:1 when printed at 100 %: measure the line. Blue is laid across the "
          "strut, red along it; the more red, the more it shrinks. Dashed struts are out of "
          "range.</p>\n";
  for (int tier = 0; tier < plan.shape.layers; ++tier) {
    page += "<figure>\n" + tierMap(plan, tier) + "</figure>\n";
  }
  return page + "</html>\n";
}

}  // namespace morphgrid
