#include "print/tolerance_json.h"

namespace morphgrid {
namespace {

nlohmann::ordered_json printsJson(const std::vector<DisturbedPrints>& kinds) {
  auto json = nlohmann::ordered_json::array();
  for (const DisturbedPrints& kind : kinds) {
    const DisturbedFigures figures = figuresOf(kind.prints);
    std::vector<double> rms;
    for (const DisturbedPrint& print : kind.prints) rms.push_back(print.rmsPercent);
    json.push_back({{"off_together", kind.what},
                    {"mean_rms_percent", figures.meanRms},
                    {"rms_95_percent", figures.rms95},
                    {"mean_max_percent", figures.meanMax},
                    {"other_equilibrium", figures.jumps},
                    {"not_converged", figures.unconverged},
                    {"rms_percent", std::move(rms)}});
  }
  return json;
}

nlohmann::ordered_json oneJson(const DisturbedPrint& print) {
  return {{"rms_percent", print.rmsPercent},
          {"max_percent", print.maxPercent},
          {"converged", print.isConverged},
          {"other_equilibrium", print.isJump}};
}

nlohmann::ordered_json leversJson(const std::vector<ToleranceLever>& levers) {
  auto json = nlohmann::ordered_json::array();
  for (const ToleranceLever& lever : levers) {
    json.push_back(
        {{"what", lever.what},
         {"movement_percent", lever.movement},
         {"first_order_percent", lever.firstOrder ? nlohmann::ordered_json(*lever.firstOrder)
                                                  : nlohmann::ordered_json(nullptr)},
         {"more_shrink_percent", lever.more},
         {"less_shrink_percent", lever.less}});
  }
  return json;
}

}  // namespace

nlohmann::ordered_json toleranceJson(const std::optional<PrintTolerance>& tolerance) {
  if (!tolerance) return nullptr;
  return {{"share", tolerance->request.share},
          {"samples", tolerance->request.samples},
          {"seed", tolerance->request.seed},
          {"model", tolerance->model},
          {"to", tolerance->hasTarget ? "target" : "design"},
          {"undisturbed", oneJson(tolerance->undisturbed)},
          {"all_less", oneJson(tolerance->shrinksLess)},
          {"all_more", oneJson(tolerance->shrinksMore)},
          {"prints", printsJson(tolerance->kinds)},
          {"tiers", leversJson(tolerance->tiers)},
          {"struts", leversJson(tolerance->struts)}};
}

}  // namespace morphgrid
