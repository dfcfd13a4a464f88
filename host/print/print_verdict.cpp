#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "print/print_record.h"
#include "print/print_verdict.h"

namespace morphgrid {
namespace {

/// What the design may do; where it gives numbers, by the rule of thumb of the shortest strut.
std::string boundsAdvice(const PrintPlan& plan, const DesignBounds& design) {
  constexpr const char* kOthers =
      "fewer and longer struts, a larger bed, or smaller hubs (pin, loops)";
  if (design.hasPrint && design.isEnforced) {
    return design.anew.empty() ? std::string(kOthers)
                               : fmt::format("run it anew with what it is printed with, {}; {}",
                                             design.anew, kOthers);
  }
  const ShrinkRange bounds =
      strutLayOf(plan.material, plan.hub.diameter).bounds(plan.figures.shortest);
  return fmt::format(
      "a design that knows of it: {}design.enforce_shrinkage in the scene, or "
      "grid.max_shrinkage = {:.2f} and material.least_shrinkage = {:.2f}; {}",
      design.hasPrint ? "" : "a [print] section and ", std::floor(100 * bounds.most) / 100,
      std::ceil(100 * bounds.least) / 100 + 0.0, kOthers);
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

std::optional<Obstacle> strutsOutOfRange(const PrintPlan& plan, const DesignBounds& design) {
  const LayFigures& figures = plan.figures;
  if (figures.outOfRange.empty()) {
    return std::nullopt;
  }
  return Obstacle{
      fmt::format("{} of {} struts are out of range: {} would have to shrink more than they can, "
                  "{} less, by {:.1f} % of their length at most",
                  figures.outOfRange.size(), figures.struts, figures.tooMuch, figures.tooLittle,
                  100 * figures.outOfRange.front().excess()),
      boundsAdvice(plan, design)};
}

std::string PrintVerdict::line() const {
  if (isGood()) {
    if (!isOfPrint) return "";
    return reservation.empty() ? "printable: yes" : "printable: yes, " + reservation;
  }
  std::vector<std::string> reasons;
  for (const Obstacle& obstacle : obstacles) {
    reasons.push_back(obstacle.wayOut.empty()
                          ? obstacle.what
                          : fmt::format("{} (way out: {})", obstacle.what, obstacle.wayOut));
  }
  return fmt::format("{}, because {}", isOfPrint ? "printable: no" : "result: useless",
                     fmt::join(reasons, "; "));
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
