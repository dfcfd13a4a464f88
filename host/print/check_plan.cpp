#include "print/check_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "print/check_overlaps.h"
#include "print/place_sheet.h"

namespace morphgrid {
namespace {

/// Between a tier's struts, swollen, and the next tier's, mm.
constexpr double kGap = 0.2;

using Reasons = std::vector<std::string>;

void throwReasons(const Reasons& reasons) {
  if (!reasons.empty()) {
    throw InputError(fmt::format("{}", fmt::join(reasons, "\n")));
  }
}

/// Two decimals, not below.
double roundedUp(double scale) { return std::ceil(scale * 100 - 1e-6) / 100; }

/// ": 10.22 mm per unit would do", with other ways out where the bed has no room for that.
std::string largerScale(const PrintPlan& plan, double scale, const char* otherWays) {
  const bool fits = scale <= plan.scale * plan.placing.room;
  return fits ? fmt::format("{:.2f} mm per unit would do, or {}", scale, otherWays)
              : fmt::format("{:.2f} mm per unit would do, for which the bed has no room; else {}",
                            scale, otherWays);
}

void checkFit(const PrintPlan& plan, Reasons& reasons) {
  if (plan.placing.room <= 0) {
    reasons.push_back(whyNoRoom(plan.hub.diameter, plan.printer));
  } else if (plan.placing.room < 1 - 1e-9) {
    reasons.push_back(fmt::format("the sheet does not fit {:g} x {:g} mm: at most {:g} mm per unit",
                                  plan.printer.bedX, plan.printer.bedY,
                                  roundedDown(plan.scale * plan.placing.room)));
  }
  const double height = plan.heights.strut + plan.heights.tube + plan.printer.lift;
  if (height > plan.printer.height) {
    reasons.push_back(fmt::format("a tier with its tubes is {:.1f} mm high, the printer {:g} mm",
                                  height, plan.printer.height));
  }
}

void checkLengths(const PrintPlan& plan, const StrutGrid& grid, Reasons& reasons) {
  const double least = plan.hub.diameter + 2 * kShortestZone;
  int count = 0;
  double shortest = least;
  for (const DesignedStrut& strut : designedStruts(grid)) {
    const double length = plan.scale * plan.enlargement * strut.printed;
    count += length < least ? 1 : 0;
    shortest = std::min(shortest, length);
  }
  if (count > 0) {
    reasons.push_back(fmt::format(
        "{} struts are too short for hubs of {:.2f} mm at {:g} mm per unit, the shortest is {:.2f} "
        "mm: {}",
        count, plan.hub.diameter, plan.scale, shortest,
        largerScale(plan, roundedUp(plan.scale * least / shortest),
                    "a thinner pin (--pin), fewer rings (--loops) or fewer nodes")));
  }
}

/// Struts of width b that leave a joint at an angle meet b / (2 sin(angle / 2)) from it.
void checkAngles(const PrintPlan& plan, Reasons& reasons) {
  int count = 0;
  double needed = 0;
  const auto check = [&](int vertex, int toA, int toB) {
    const Eigen::Vector2d apex = plan.positions.col(vertex);
    const Eigen::Vector2d a = (plan.positions.col(toA) - apex).normalized();
    const Eigen::Vector2d b = (plan.positions.col(toB) - apex).normalized();
    const double sine = std::sqrt(std::max(0.0, (1 - a.dot(b)) / 2));
    const double diameter = plan.strutWidth() / std::max(sine, 1e-6);
    count += diameter > plan.hub.diameter ? 1 : 0;
    needed = std::max(needed, diameter);
  };
  forEachCorner(plan.shape, [&](const Corner& corner) {
    if (corner.isLateral) check(corner.apex, corner.a, corner.b);
  });
  forEachVertex(plan.shape, [&](const GridPlace& place) {  // Struts of one line, where it folds.
    const int vertex = plan.shape.index(place);
    const int row = plan.shape.verticesU;
    if (place.i > 0 && place.i < plan.shape.cellsU()) check(vertex, vertex - 1, vertex + 1);
    if (place.j > 0 && place.j < plan.shape.cellsV()) check(vertex, vertex - row, vertex + row);
  });
  if (count > 0) {
    reasons.push_back(fmt::format(
        "{} corners are so sharp that struts of {:.2f} mm meet before hubs of {:.2f} mm: hubs of "
        "{:.2f} mm would do (--loops, --pin), or fewer lines a strut",
        count, plan.strutWidth(), plan.hub.diameter, needed));
  }
}

void checkSpacing(const PrintPlan& plan, Reasons& reasons) {
  const PrintHeights& heights = plan.heights;
  if (plan.shape.layers < 2) return;
  const double needed = heights.strutSwollen + kGap;
  if (heights.spacing < needed) {
    reasons.push_back(
        fmt::format("tiers are {:.2f} mm apart, but a strut of {:.2f} mm swells to {:.2f} mm: {}",
                    heights.spacing, heights.strut, heights.strutSwollen,
                    largerScale(plan, roundedUp(plan.scale * needed / heights.spacing),
                                "fewer passes (--passes)")));
  } else if (heights.tube < plan.material.tube.passHeight / 2) {
    reasons.push_back(fmt::format("hubs leave tubes a height of {:.2f} mm: {}", heights.tube,
                                  "a larger scale would do, or fewer passes (--passes)"));
  }
}

}  // namespace

double roundedDown(double scale) {
  const double step = 5 * std::pow(10.0, std::floor(std::log10(scale)) - 3);
  // Through the reciprocal where that is whole: 13.85 and not 13.850000000000001.
  const double count = std::floor(scale / step + 1e-9);
  return step < 1 ? count / std::round(1 / step) : count * step;
}

void requireLayable(const Printer& printer, const PrintMaterial& material) {
  Reasons reasons;
  const auto check = [&](const char* what, double height) {
    if (height < printer.leastHeight - 1e-9 || height > printer.largestHeight + 1e-9) {
      reasons.push_back(fmt::format("{} are {:.3g} mm high; {} lays {:g} to {:g} mm", what, height,
                                    printer.name, printer.leastHeight, printer.largestHeight));
    }
  };
  check("the lowest passes",
        std::min(material.heightOf(0), material.heightOf(material.strut.passes - 1)));
  check("the highest passes",
        std::max(material.heightOf(0), material.heightOf(material.strut.passes - 1)));
  check("a hub's rings", material.hub.every * material.strut.passHeight);
  check("a tube's passes", material.tube.passHeight);
  throwReasons(reasons);
}

void requirePrintable(const PrintPlan& plan, const StrutGrid& grid) {
  Reasons reasons;
  checkFit(plan, reasons);
  checkLengths(plan, grid, reasons);
  checkAngles(plan, reasons);
  checkSpacing(plan, reasons);
  if (const auto overlaps = findOverlaps(plan); overlaps && reasons.empty()) {
    reasons.push_back(*overlaps);
  }
  throwReasons(reasons);
}

}  // namespace morphgrid
