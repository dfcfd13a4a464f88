#include <fmt/format.h>

#include <cmath>

#include "print/print_record.h"

namespace morphgrid {
namespace {

/// What a design may ask for, by the rule of thumb of the shortest strut.
std::string boundsAdvice(const PrintPlan& plan) {
  const ShrinkRange bounds =
      strutLayOf(plan.material, plan.hub.diameter).bounds(plan.figures.shortest);
  return fmt::format(
      "a design within grid.max_shrinkage = {:.2f} and material.least_shrinkage = {:.2f} "
      "(design.enforce_shrinkage), fewer and longer struts, a larger bed, or smaller hubs (--pin, "
      "--loops)",
      std::floor(100 * bounds.most) / 100, std::ceil(100 * bounds.least) / 100 + 0.0);
}

}  // namespace

std::string nameOf(const GridShape& shape, const Strut& strut) {
  const GridPlace place = shape.place(strut.from);
  return fmt::format("strut {} {} {} of tier {}",
                     strut.direction == Strut::Direction::u ? 'u' : 'v', place.i, place.j,
                     place.layer + 1);
}

double stackHeight(const PrintPlan& plan) {
  return plan.shape.layers * plan.heights.strut + (plan.shape.layers - 1) * plan.heights.tube;
}

std::string printVerdict(const PrintRecord& record) {
  const LayFigures& figures = record.plan.figures;
  if (figures.outOfRange.empty()) {
    return "printable: yes";
  }
  return fmt::format(
      "printable: no, because {} of {} struts are out of range: {} would have to shrink more than "
      "they can, {} less, by {:.1f} % of their length at most. Ways out: {}",
      figures.outOfRange.size(), figures.struts, figures.tooMuch, figures.tooLittle,
      100 * figures.outOfRange.front().excess(), boundsAdvice(record.plan));
}

std::vector<std::string> printNotices(const PrintRecord& record) {
  std::vector<std::string> notices = record.notices;
  const PrintMaterial& material = record.plan.material;
  if (!material.hub.isMeasured || (!material.tube.isMeasured && record.plan.shape.layers > 1)) {
    notices.push_back(
        fmt::format("{}: what the bath does to hubs and tubes was not measured; all "
                    "heights depend on it",
                    material.name));
  }
  if (record.shape && !record.shape->isConverged) {
    notices.emplace_back("the grid that is laid was simulated, but did not come to rest");
  }
  if (record.shape && !record.shape->endsThereFromFlat) {
    notices.push_back(fmt::format(
        "what is laid has more than one equilibrium: from flat it morphs into another, {:.3g} % "
        "(RMS) from {}; help it by hand, or take another design",
        *record.shape->fromFlatRmsPercent,
        record.shape->hasTarget ? "the target" : "where the design ends"));
  }
  if (record.tolerance) {
    for (std::string& notice : toleranceNotices(*record.tolerance)) {
      notices.push_back(std::move(notice));
    }
  }
  return notices;
}

}  // namespace morphgrid
