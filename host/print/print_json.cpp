#include <nlohmann/json.hpp>

#include "print/print_record.h"
#include "print/tolerance_json.h"

namespace morphgrid {
namespace {

using nlohmann::ordered_json;

ordered_json materialJson(const PrintMaterial& material) {
  return {{"name", material.name},
          {"source", material.source},
          {"year", material.year},
          {"caveat", material.caveat},
          {"change_along", material.along.change},
          {"change_across", material.across.change},
          {"bath_c", material.bath},
          {"hub_measured", material.hub.isMeasured},
          {"tube_measured", material.tube.isMeasured}};
}

ordered_json sizesJson(const PrintPlan& plan) {
  return {{"bed_mm", {plan.printer.bedX, plan.printer.bedY}},
          {"nozzle_mm", plan.printer.nozzle},
          {"filament_diameter_mm", plan.printer.filamentDiameter},
          {"line_width_mm", plan.printer.lineWidth},
          {"pass_height_mm", plan.material.strut.passHeight},
          {"scale_mm_per_unit", plan.scale},
          {"enlargement", plan.enlargement},
          {"extent_mm", {plan.placing.extent.x(), plan.placing.extent.y()}},
          {"rotation_degrees", plan.placing.degrees},
          {"strut_width_mm", plan.strutWidth()},
          {"strut_height_mm", plan.heights.strut},
          {"strut_height_after_bath_mm", plan.heights.strutSwollen},
          {"hub_diameter_mm", plan.hub.diameter},
          {"hole_diameter_mm", plan.hub.hole},
          {"tier_spacing_after_bath_mm", plan.heights.spacing},
          {"tube_height_mm", plan.heights.tube},
          {"pin_diameter_mm", plan.request.pin},
          {"pins", plan.shape.layers > 1 ? plan.shape.layerVertexCount() : 0},
          {"stack_height_mm", stackHeight(plan)}};
}

ordered_json strutsJson(const PrintPlan& plan) {
  const LayFigures& figures = plan.figures;
  ordered_json outside = ordered_json::array();
  for (const StrutOutOfRange& strut : figures.outOfRange) {
    outside.push_back({{"strut", nameOf(plan.shape, strut.strut)},
                       {"wanted_percent", 100 * strut.wanted},
                       {"least_percent", 100 * strut.bounds.least},
                       {"most_percent", 100 * strut.bounds.most}});
  }
  return {{"count", figures.struts},
          {"shortest_mm", figures.shortest},
          {"median_mm", figures.median},
          {"longest_mm", figures.longest},
          {"mean_share_across", figures.meanShareAcross},
          {"too_much", figures.tooMuch},
          {"too_little", figures.tooLittle},
          {"out_of_range", std::move(outside)},
          {"rounded", figures.rounded},
          {"largest_rounding_percent", 100 * figures.largestRounding}};
}

ordered_json tierJson(const TierFigures& tier) {
  const auto metres = [&](PathKind kind) {
    return tier.pathMm[static_cast<std::size_t>(kind)] / 1000;
  };
  return {{"passes", tier.passes},
          {"path_m", tier.laidMm() / 1000},
          {"along_m", metres(PathKind::along)},
          {"across_m", metres(PathKind::across)},
          {"hubs_m", metres(PathKind::hub)},
          {"tubes_m", metres(PathKind::tube)},
          {"travel_m", tier.travelMm / 1000},
          {"retractions", tier.retractions},
          {"filament_mm", tier.filamentMm},
          {"filament_g", tier.grams},
          {"seconds", tier.seconds}};
}

ordered_json shapeJson(const std::optional<LaidShape>& shape) {
  if (!shape) return nullptr;
  return {
      {"model", shape->model},
      {"to", shape->hasTarget ? "target" : "design"},
      {"design_rms_percent", shape->designRmsPercent},
      {"design_max_percent", shape->designMaxPercent},
      {"laid_rms_percent", shape->laidRmsPercent},
      {"laid_max_percent", shape->laidMaxPercent},
      {"converged", shape->isConverged},
      {"from_flat_rms_percent", shape->fromFlatRmsPercent ? ordered_json(*shape->fromFlatRmsPercent)
                                                          : ordered_json(nullptr)},
      {"same_equilibrium_from_flat", shape->endsThereFromFlat}};
}

}  // namespace

std::string printJson(const PrintRecord& record) {
  ordered_json tiers = ordered_json::array();
  for (const TierFigures& tier : record.tiers) tiers.push_back(tierJson(tier));
  const ordered_json json{{"scene", record.plan.name},
                          {"verdict", record.verdict.line()},
                          {"printable", record.verdict.isGood()},
                          {"printer", record.plan.printer.name},
                          {"material", materialJson(record.plan.material)},
                          {"sizes", sizesJson(record.plan)},
                          {"struts", strutsJson(record.plan)},
                          {"tiers", std::move(tiers)},
                          {"distance", shapeJson(record.shape)},
                          {"tolerance", toleranceJson(record.tolerance)},
                          {"notices", printNotices(record)}};
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace morphgrid
