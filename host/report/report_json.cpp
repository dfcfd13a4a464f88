#include "report/report_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/degrees.h"
#include "report/judge_run.h"

namespace morphgrid {
namespace {

using nlohmann::ordered_json;

/// JSON has no infinity: what is not finite becomes null.
ordered_json number(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json number(const std::optional<double>& value) {
  return value ? number(*value) : ordered_json(nullptr);
}

ordered_json eigenvalueToJson(const Equilibrium& stage) {
  if (!stage.smallestEigenvalue) {
    return nullptr;
  }
  const SmallestEigenvalue& e = *stage.smallestEigenvalue;
  return {{"value", number(e.value)},   {"residual", number(e.residual)},
          {"iterations", e.iterations}, {"converged", e.converged},
          {"seconds", e.seconds},       {"verdict", toString(verdictOf(stage))}};
}

ordered_json toJson(const Equilibrium& stage) {
  return {{"iterations", stage.iterations},
          {"converged", stage.converged},
          {"reason", toString(stage.reason)},
          {"residual", number(stage.residual)},
          {"energy", number(stage.energy)},
          {"seconds", stage.seconds},
          {"smallest_eigenvalue", eigenvalueToJson(stage)}};
}

ordered_json toJson(const SymmetryFigures& symmetry) {
  return {{"kind", toString(symmetry.kind)},
          {"target_percent", symmetry.targetPercent},
          {"result_percent", symmetry.resultPercent}};
}

ordered_json toJson(const InverseStep& step) {
  return {{"kind", toString(step.kind)},
          {"number", step.number},
          {"rms_percent", step.rmsPercent},
          {"max_percent", step.maxPercent},
          {"largest_shrink_percent", step.largestShrinkPercent},
          {"largest_strain_percent", number(step.largestStrainPercent)},
          {"struts_at_bound", step.strutsAtBound},
          {"cycles", step.cycles},
          {"adjoint_products", step.adjointProducts},
          {"seconds", step.seconds}};
}

ordered_json toJson(const FromFlat& fromFlat) {
  return {{"same_equilibrium", fromFlat.sameEquilibrium},
          {"rms_percent", fromFlat.rmsPercent},
          {"least_eigenvalue_ratio", number(fromFlat.leastStiffness)},
          {"settled", fromFlat.isSettled},
          {"cycles", fromFlat.cycles},
          {"seconds", fromFlat.seconds}};
}

ordered_json toJson(const InverseDesign& inverse) {
  ordered_json steps = ordered_json::array();
  for (const InverseStep& step : inverse.steps) {
    steps.push_back(toJson(step));
  }
  return {{"ending", inverse.ending},
          {"from_flat", inverse.fromFlat ? toJson(*inverse.fromFlat) : ordered_json(nullptr)},
          {"steps_refused_as_soft", inverse.refusedAsSoft},
          {"steps", std::move(steps)}};
}

ordered_json toJson(const StageEffort& effort) {
  return {{"iterations", effort.iterations}, {"seconds", effort.seconds}};
}

ordered_json toJson(const std::vector<CutoffConsequence>& cutoffs) {
  ordered_json array = ordered_json::array();
  for (const CutoffConsequence& c : cutoffs) {
    array.push_back({{"p", c.cutoff},
                     {"curvature", c.curvatureLimit},
                     {"layer_spacing_limit", number(c.layerSpacingLimit)},
                     {"fewest_nodes", c.fewestNodes}});
  }
  return array;
}

ordered_json toJson(const MeasurementFigures& m) {
  return {{"longest_isoline_u", m.longestIsolineU},
          {"longest_isoline_v", m.longestIsolineV},
          {"largest_curvature", m.largestCurvature},
          {"layer_spacing_limit", number(m.layerSpacingLimit)},
          {"fewest_nodes", m.fewestNodes},
          {"cutoffs", toJson(m.cutoffs)},
          {"suggested_cutoff", number(m.suggestedCutoff)},
          {"curvature_noise", number(m.curvatureNoise)}};
}

ordered_json toJson(const MeshFigures& m) {
  return {{"file", m.file},
          {"triangles", m.triangles},
          {"rays", m.rays},
          {"missed", m.missed},
          {"largest_jump", m.largestJump},
          {"seconds_build", m.secondsBuild},
          {"seconds_rays", m.secondsRays}};
}

ordered_json toJson(const NetFigures& n) {
  return {{"kind", nameOf(n.kind)},
          {"modulus", number(n.modulus)},
          {"blend", n.blend},
          {"strut_ratio", number(n.quality.strutRatio)},
          {"mean_angle_deviation_degrees", degrees(n.quality.meanAngleDeviation)},
          {"largest_angle_deviation_degrees", degrees(n.quality.largestAngleDeviation)}};
}

ordered_json toJson(const SheetFigures& s) {
  return {{"mean_angle_error_degrees", degrees(s.meanAngle)},
          {"largest_angle_error_degrees", degrees(s.largestAngle)},
          {"scale_ratio", s.scaleRatio},
          {"lateral_struts", s.lateralStruts},
          {"struts_out_of_range", s.strutsOutOfRange},
          {"net_struts_beyond_range", s.barsBeyondRange},
          {"mean_twist_degrees", degrees(s.meanTwist)},
          {"largest_twist_degrees", degrees(s.largestTwist)},
          {"size_x", s.sizeX},
          {"size_y", s.sizeY},
          {"fitting_layer_spacing", number(s.fittingLayerSpacing)},
          {"iterations", s.iterations},
          {"seconds", s.seconds}};
}

ordered_json toJson(const GridFigures& g) {
  return {{"nodes_u", g.shape.verticesU - 1}, {"nodes_v", g.shape.verticesV - 1},
          {"layers", g.shape.layers},         {"spacing", g.spacing},
          {"layer_spacing", g.layerSpacing},  {"vertices", g.shape.vertexCount()},
          {"struts", g.shape.strutCount()},   {"bend_shrink_percent", g.bendShrinkPercent}};
}

ordered_json toJson(const StrutErrors& e) {
  return {
      {"l0_percent", e.l0Percent}, {"lb_percent", e.lbPercent}, {"angle_percent", e.anglePercent}};
}

ordered_json histogramOf(const DistanceSpread& s) {
  return {{"bin_percent", s.binPercent}, {"counts", s.counts}};
}

template <typename Distance>
void addDistances(ordered_json& json, const std::string& prefix, const Distance& d) {
  json[prefix + "rms_percent"] = d.rmsPercent;
  json[prefix + "max_percent"] = d.maxPercent;
  json[prefix + "median_percent"] = d.spread.medianPercent;
  json[prefix + "percentile_90_percent"] = d.spread.percentile90;
  json[prefix + "percentile_99_percent"] = d.spread.percentile99;
  json[prefix + "histogram"] = histogramOf(d.spread);
}

ordered_json toJson(const TargetDistance& d) {
  ordered_json json;
  addDistances(json, "", d);
  if (d.closest) addDistances(json, "closest_point_", *d.closest);
  json["diagonal"] = d.diagonal;
  json["axis_parallel_diagonal"] = d.axisParallelDiagonal;
  return json;
}

ordered_json toJson(const ShrinkCounts& s) {
  return {{"largest_percent", s.largestPercent},
          {"struts_over_limit", s.strutsOverLimit},
          {"struts_at_limit", s.strutsAtLimit},
          {"struts_growing", s.strutsGrowing},
          {"largest_growth_percent", s.largestGrowthPercent},
          {"struts_under_least", s.strutsUnderLeast}};
}

ordered_json toJson(const ShrinkFigures& s) {
  ordered_json json = toJson(static_cast<const ShrinkCounts&>(s));
  json["layers"] = ordered_json::array();
  for (const ShrinkCounts& layer : s.layers) {
    json["layers"].push_back(toJson(layer));
  }
  return json;
}

ordered_json toJson(const StrainFigures& s) {
  return {{"largest_percent", s.largestPercent},
          {"mean_percent", s.meanPercent},
          {"struts_over_limit", s.strutsOverLimit}};
}

ordered_json toJson(const WeightFigures& w) {
  return {{"newtons", w.newtons}, {"sag", w.sag ? ordered_json(*w.sag) : nullptr}};
}

ordered_json toJson(const GridPlace& place) { return {place.i, place.j, place.layer}; }

ordered_json toJson(const CloseStruts& c) {
  const bool any = c.count > 0;
  return {{"thickness", c.thickness},
          {"count", c.count},
          {"smallest_clearance", any ? ordered_json(c.smallestClearance) : nullptr},
          {"closest", any ? toJson(c.closest) : nullptr}};
}

ordered_json toJson(const Feasibility& f) {
  const bool cut = f.selfIntersection.cells > 0;
  return {{"inverted_cells", f.cells.inverted},
          {"collapsed_cells", f.cells.collapsed},
          {"smallest_relative_area", f.cells.smallestRelativeArea},
          {"smallest_cell", toJson(f.cells.smallest)},
          {"self_intersecting_cells", f.selfIntersection.cells},
          {"first_self_intersection", cut ? toJson(f.selfIntersection.first) : nullptr},
          {"close_struts", f.closeStruts ? toJson(*f.closeStruts) : nullptr}};
}

ordered_json toJson(const BarSizes& b) {
  return {{"width", b.width}, {"height", b.height}, {"post", b.post}, {"joint", b.joint}};
}

ordered_json toJson(const std::vector<Obstacle>& obstacles) {
  ordered_json array = ordered_json::array();
  for (const Obstacle& obstacle : obstacles) {
    array.push_back({{"what", obstacle.what}, {"way_out", obstacle.wayOut}});
  }
  return array;
}

ordered_json toJson(const PrintAssessment& p) {
  return {{"printer", p.printer},
          {"material", p.material},
          {"printer_digest", p.printerDigest},
          {"material_digest", p.materialDigest},
          {"scale_mm_per_unit", p.scale},
          {"enlargement", p.enlargement},
          {"obstacles", toJson(p.obstacles)}};
}

ordered_json toJson(const PrintVerdict& v) {
  return {{"printable", v.isOfPrint ? ordered_json(v.isGood()) : ordered_json(nullptr)},
          {"line", v.line()},
          {"obstacles", toJson(v.obstacles)}};
}

/// [x, y] in the scene's unit, and in mm with [print].
ordered_json printedSheetToJson(const RunRecord& record) {
  if (!record.printedSheet) {
    return nullptr;
  }
  const auto pair = [](const Eigen::Array2d& size) { return ordered_json{size.x(), size.y()}; };
  const auto mm = record.printedSheetMm();
  return {{"size", pair(*record.printedSheet)},
          {"size_mm", mm ? pair(*mm) : ordered_json(nullptr)}};
}

template <typename Figures>
ordered_json orNull(const std::optional<Figures>& figures) {
  return figures ? toJson(*figures) : ordered_json(nullptr);
}
}  // namespace

std::string toJson(const RunRecord& record) {
  const ordered_json json{
      {"scene", record.scene},
      {"title", record.title},
      {"method", record.method},
      {"scaling", record.scaling},
      {"model", record.model},
      {"device", record.device},
      {"seconds_total", record.secondsTotal},
      {"grid", toJson(record.grid)},
      {"net", orNull(record.net)},
      {"mesh", orNull(record.mesh)},
      {"measurement", orNull(record.measurement)},
      {"sheet", orNull(record.sheet)},
      {"in_plane", orNull(record.inPlane)},
      {"print_scale", record.printScale},
      {"printed_sheet", printedSheetToJson(record)},
      {"bars", orNull(record.bars)},
      {"print", orNull(record.print)},
      {"full", orNull(record.full)},
      {"before_inverse_design", orNull(record.beforeInverse)},
      {"inverse_design", orNull(record.inverse)},
      {"errors", orNull(record.errors)},
      {"distance_to_target", orNull(record.distance)},
      {"symmetry", orNull(record.symmetry)},
      {"shrink", orNull(record.shrink)},
      {"strain", orNull(record.strain)},
      {"weight", orNull(record.weight)},
      {"feasibility", orNull(record.feasibility)},
      {"device_failure",
       record.deviceFailure ? ordered_json(*record.deviceFailure) : ordered_json(nullptr)},
      {"notices", textsOf(record.notices)},
      {"interrupted", record.isInterrupted},
      {"verdict", toJson(judgeRun(record))}};
  return json.dump(2) + "\n";
}
}  // namespace morphgrid
