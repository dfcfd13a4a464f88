#include "report/report_files.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

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

ordered_json toJson(const InverseStep& step) {
  return {{"kind", toString(step.kind)},
          {"number", step.number},
          {"rms_percent", step.rmsPercent},
          {"max_percent", step.maxPercent},
          {"largest_shrink_percent", step.largestShrinkPercent},
          {"struts_at_bound", step.strutsAtBound},
          {"cycles", step.cycles},
          {"adjoint_products", step.adjointProducts},
          {"seconds", step.seconds}};
}

ordered_json toJson(const FromFlat& fromFlat) {
  return {{"same_equilibrium", fromFlat.sameEquilibrium}, {"rms_percent", fromFlat.rmsPercent}};
}

ordered_json toJson(const InverseDesign& inverse) {
  ordered_json steps = ordered_json::array();
  for (const InverseStep& step : inverse.steps) {
    steps.push_back(toJson(step));
  }
  return {{"ending", inverse.ending},
          {"from_flat", inverse.fromFlat ? toJson(*inverse.fromFlat) : ordered_json(nullptr)},
          {"steps", std::move(steps)}};
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

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

ordered_json toJson(const NetFigures& n) {
  return {{"kind", nameOf(n.kind)},
          {"modulus", number(n.modulus)},
          {"blend", n.blend},
          {"strut_ratio", number(n.quality.strutRatio)},
          {"mean_angle_deviation_degrees", degrees(n.quality.meanAngleDeviation)},
          {"largest_angle_deviation_degrees", degrees(n.quality.largestAngleDeviation)}};
}

ordered_json toJson(const GridFigures& g) {
  return {{"nodes_u", g.shape.verticesU - 1},
          {"nodes_v", g.shape.verticesV - 1},
          {"layers", g.shape.layers},
          {"layer_spacing", g.layerSpacing},
          {"vertices", g.shape.vertexCount()},
          {"struts", g.shape.strutCount()},
          {"bend_shrink_percent", g.bendShrinkPercent}};
}

ordered_json toJson(const StrutErrors& e) {
  return {
      {"l0_percent", e.l0Percent}, {"lb_percent", e.lbPercent}, {"angle_percent", e.anglePercent}};
}

ordered_json histogramOf(const DistanceSpread& s) {
  return {{"bin_percent", s.binPercent}, {"counts", s.counts}};
}

ordered_json toJson(const TargetDistance& d) {
  return {{"rms_percent", d.rmsPercent},
          {"max_percent", d.maxPercent},
          {"median_percent", d.spread.medianPercent},
          {"percentile_90_percent", d.spread.percentile90},
          {"percentile_99_percent", d.spread.percentile99},
          {"histogram", histogramOf(d.spread)},
          {"closest_point_rms_percent", d.closestPointRmsPercent},
          {"closest_point_max_percent", d.closestPointMaxPercent},
          {"closest_point_median_percent", d.closestPointSpread.medianPercent},
          {"closest_point_percentile_90_percent", d.closestPointSpread.percentile90},
          {"closest_point_percentile_99_percent", d.closestPointSpread.percentile99},
          {"closest_point_histogram", histogramOf(d.closestPointSpread)}};
}

ordered_json toJson(const ShrinkCounts& s) {
  return {{"largest_percent", s.largestPercent},
          {"struts_over_limit", s.strutsOverLimit},
          {"struts_at_limit", s.strutsAtLimit},
          {"struts_growing", s.strutsGrowing},
          {"largest_growth_percent", s.largestGrowthPercent}};
}

ordered_json toJson(const ShrinkFigures& s) {
  ordered_json json = toJson(static_cast<const ShrinkCounts&>(s));
  json["layers"] = ordered_json::array();
  for (const ShrinkCounts& layer : s.layers) {
    json["layers"].push_back(toJson(layer));
  }
  return json;
}

ordered_json toJson(const LatticePlace& place) { return {place.i, place.j, place.layer}; }

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

template <typename Figures>
ordered_json orNull(const std::optional<Figures>& figures) {
  return figures ? toJson(*figures) : ordered_json(nullptr);
}

void appendSamples(std::string& csv, const char* stage, const std::optional<Equilibrium>& run) {
  if (run) {
    for (const ConvergenceSample& s : run->history) {
      csv += fmt::format("{},{},{},{},{},{}\n", stage, s.iteration, s.energy, s.residual, s.seconds,
                         s.gridShare);
    }
  }
}

/// Rows of "what, ours, the paper's".
class Table {
 public:
  explicit Table(const RunRecord& record) : published_(record.published) {
    text_ = fmt::format("{:<26}{:>16}", record.title, "morphgrid");
    if (published_) {
      text_ += fmt::format("{:>16}", "paper " + published_->figure);
    }
    text_ += '\n';
  }

  void row(const char* what, const std::string& ours, const std::string& papers = "") {
    text_ += fmt::format("  {:<24}{:>16}", what, ours);
    if (published_ && !papers.empty()) {
      text_ += fmt::format("{:>16}", papers);
    }
    text_ += '\n';
  }
  void line(const std::string& text) { text_ += text + '\n'; }
  const std::string& text() const { return text_; }

 private:
  const std::optional<PublishedFigures>& published_;
  std::string text_;
};

/// "" where the paper says nothing.
template <typename... Values>
std::string ifAll(const char* format, const std::optional<Values>&... values) {
  return (values && ...) ? fmt::format(fmt::runtime(format), *values...) : "";
}

void addMeasurement(Table& table, const RunRecord& record, const PublishedFigures& paper) {
  if (!record.measurement) {
    return;
  }
  const MeasurementFigures& m = *record.measurement;
  table.row("longest isolines, u x v",
            fmt::format("{:.4g} x {:.4g}", m.longestIsolineU, m.longestIsolineV),
            ifAll("{:.4g} x {:.4g}", paper.longestIsolineU, paper.longestIsolineV));
  table.row("largest curvature", fmt::format("{:.4g}", m.largestCurvature),
            ifAll("{:.4g}", paper.largestCurvature));
  table.row("layer spacing at most", fmt::format("{:.4g}", m.layerSpacingLimit));
  table.row("fewest nodes", fmt::format("{}", m.fewestNodes));
  if (m.curvatureNoise) {
    table.row("curvature noise", fmt::format("{:.4g}", *m.curvatureNoise));
  }
}

void addNet(Table& table, const RunRecord& record) {
  if (!record.net) {
    return;
  }
  const NetFigures& n = *record.net;
  table.row("net", nameOf(n.kind));
  if (n.modulus) {
    table.row("  modulus, blend", fmt::format("{:.4g}, {:.3g}", *n.modulus, n.blend));
  }
  table.row("  longest / shortest", fmt::format("{:.3g}", n.quality.strutRatio));
  table.row("  off 90 deg, mean / max",
            fmt::format("{:.1f} / {:.1f} deg", degrees(n.quality.meanAngleDeviation),
                        degrees(n.quality.largestAngleDeviation)));
}

/// What other cutoffs would mean: advice for a design, so only where nothing is solved yet.
void addCutoffs(Table& table, const RunRecord& record) {
  if (!record.measurement || record.inPlane) {
    return;
  }
  const MeasurementFigures& m = *record.measurement;
  constexpr const char* kRow = "  {:<24}{:>16}{:>16}{:>16}";
  table.line(fmt::format(kRow, "curvature cutoff", "curvature", "spacing at most", "fewest nodes"));
  for (const CutoffConsequence& c : m.cutoffs) {
    table.line(fmt::format(kRow, fmt::format("  {:g} % (p = {:g})", 100 * c.cutoff, c.cutoff),
                           fmt::format("{:.4g}", c.curvatureLimit),
                           fmt::format("{:.4g}", c.layerSpacingLimit),
                           fmt::format("{:.6g}", c.fewestNodes)));
  }
  table.row("suggested p", m.suggestedCutoff ? fmt::format("{:g}", *m.suggestedCutoff) : "none");
}

void addMesh(Table& table, const RunRecord& record) {
  if (!record.mesh) {
    return;
  }
  const MeshFigures& m = *record.mesh;
  table.row("triangles", fmt::format("{}", m.triangles));
  table.row("rays, missed", fmt::format("{}, {}", m.rays, m.missed));
  table.row("steepest step", fmt::format("{:.3g}", m.largestJump));
  if (record.inPlane) {
    return;
  }
  // A check is where people choose their box.
  const Eigen::Vector3d& low = m.extent.min();
  const Eigen::Vector3d& high = m.extent.max();
  table.line(
      fmt::format("  mesh spans x {:.6g} to {:.6g}, y (u) {:.6g} to {:.6g}, z (v) {:.6g} to {:.6g}",
                  low.x(), high.x(), low.y(), high.y(), low.z(), high.z()));
  if (m.suggestedBox) {
    const SamplingBox& box = *m.suggestedBox;
    table.line(
        fmt::format("  a box without holes: u_start = {:.6g}, v_start = {:.6g}, u_length = {:.6g}, "
                    "v_length = {:.6g}",
                    box.uStart, box.vStart, box.uLength, box.vLength));
  }
}

std::string counted(long iterations) {
  return fmt::format("{} {}", iterations, iterations == 1 ? "iteration" : "iterations");
}

void addStage(Table& table, const char* name, const std::optional<Equilibrium>& stage) {
  if (!stage) {
    return;
  }
  table.line(fmt::format(
      "  {:<9} {} ({}), residual {:.2g}, energy {:.6g}, {:.2f} s", name, counted(stage->iterations),
      stage->converged ? "converged" : "NOT converged: " + toString(stage->reason), stage->residual,
      stage->energy, stage->seconds));
  if (stage->smallestEigenvalue) {
    const SmallestEigenvalue& e = *stage->smallestEigenvalue;
    table.line(fmt::format("  {:<9} {}: smallest eigenvalue {:.3g}, residual {:.2g}, {}, {:.2f} s",
                           "", toString(verdictOf(*stage)), e.value, e.residual,
                           counted(e.iterations), e.seconds));
  }
}

/// Only what is wrong.
void addFeasibility(Table& table, const RunRecord& record) {
  const auto rowIfAny = [&](const char* what, int count) {
    if (count > 0) {
      table.row(what, fmt::format("{}", count));
    }
  };
  if (record.shrink) {
    rowIfAny("struts at the limit", record.shrink->strutsAtLimit);
    rowIfAny("struts that must grow", record.shrink->strutsGrowing);
  }
  if (record.feasibility) {
    const Feasibility& f = *record.feasibility;
    rowIfAny("inverted cells", f.cells.inverted);
    rowIfAny("collapsed cells", f.cells.collapsed);
    rowIfAny("self-intersecting cells", f.selfIntersection.cells);
    rowIfAny("struts too close", f.closeStruts ? f.closeStruts->count : 0);
  }
}

void addInverse(Table& table, const RunRecord& record) {
  if (record.printScale != 1) {
    table.line(fmt::format("  printed {:.3f} times as large as the in-plane stage left the sheet",
                           record.printScale));
  }
  if (record.inverse) {
    const std::vector<InverseStep>& steps = record.inverse->steps;
    const InverseStep& first = steps.front();
    const InverseStep& last = steps.back();
    table.line(fmt::format(
        "  inverse design: {} steps ({}), distance {:.3g} / {:.3g} to {:.3g} / {:.3g} %, {:.2f} s",
        steps.size() - 1, record.inverse->ending, first.rmsPercent, first.maxPercent,
        last.rmsPercent, last.maxPercent, last.seconds));
  }
}

void addResults(Table& table, const RunRecord& record, const PublishedFigures& paper) {
  const auto percent = [](double value) { return fmt::format("{:.2f} %", value); };
  if (record.errors) {
    table.row("L0 error", percent(record.errors->l0Percent), ifAll("{:.2f} %", paper.l0Percent));
    table.row("L_b error", percent(record.errors->lbPercent), ifAll("{:.2f} %", paper.lbPercent));
    table.row("angle error", percent(record.errors->anglePercent),
              ifAll("{:.2f} %", paper.anglePercent));
  }
  if (record.distance) {
    const TargetDistance& d = *record.distance;
    table.row("distance, RMS / max", fmt::format("{:.2f} / {:.2f} %", d.rmsPercent, d.maxPercent));
    table.row("  to closest point",
              fmt::format("{:.2f} / {:.2f} %", d.closestPointRmsPercent, d.closestPointMaxPercent));
  }
  if (record.shrink) {
    table.row("largest shrink", percent(record.shrink->largestPercent));
    table.row("struts over the limit", fmt::format("{}", record.shrink->strutsOverLimit));
  }
  addFeasibility(table, record);
}

void addFigures(Table& table, const RunRecord& record) {
  const PublishedFigures paper = record.published.value_or(PublishedFigures{});
  const GridFigures& g = record.grid;
  addMesh(table, record);
  addMeasurement(table, record, paper);
  table.row("nodes, u x v", fmt::format("{} x {}", g.shape.verticesU - 1, g.shape.verticesV - 1),
            ifAll("{} x {}", paper.nodesU, paper.nodesV));
  table.row("layers, spacing", fmt::format("{}, {:.4g}", g.shape.layers, g.layerSpacing));
  table.row("vertices, struts", fmt::format("{}, {}", g.shape.vertexCount(), g.shape.strutCount()));
  table.row("largest L_b shrink", fmt::format("{:.1f} %", g.bendShrinkPercent),
            ifAll("{:.1f} %", paper.bendShrinkPercent));
  addNet(table, record);
  addCutoffs(table, record);
  addResults(table, record, paper);
}

}  // namespace

std::string toJson(const RunRecord& record) {
  const ordered_json json{
      {"scene", record.scene},
      {"title", record.title},
      {"method", record.method},
      {"scaling", record.scaling},
      {"device", record.device},
      {"seconds_total", record.secondsTotal},
      {"grid", toJson(record.grid)},
      {"net", orNull(record.net)},
      {"mesh", orNull(record.mesh)},
      {"measurement", orNull(record.measurement)},
      {"in_plane", orNull(record.inPlane)},
      {"print_scale", record.printScale},
      {"full", orNull(record.full)},
      {"inverse_design", orNull(record.inverse)},
      {"errors", orNull(record.errors)},
      {"distance_to_target", orNull(record.distance)},
      {"shrink", orNull(record.shrink)},
      {"feasibility", orNull(record.feasibility)},
      {"device_failure",
       record.deviceFailure ? ordered_json(*record.deviceFailure) : ordered_json(nullptr)},
      {"notices", record.notices}};
  return json.dump(2) + "\n";
}

std::string toInverseCsv(const InverseDesign& inverse) {
  std::string csv =
      "kind,number,rms_percent,max_percent,largest_shrink_percent,struts_at_bound,cycles,"
      "adjoint_products,seconds\n";
  for (const InverseStep& s : inverse.steps) {
    csv += fmt::format("{},{},{},{},{},{},{},{},{}\n", toString(s.kind), s.number, s.rmsPercent,
                       s.maxPercent, s.largestShrinkPercent, s.strutsAtBound, s.cycles,
                       s.adjointProducts, s.seconds);
  }
  return csv;
}

std::string toConvergenceCsv(const RunRecord& record) {
  std::string csv = "stage,iteration,energy,residual,seconds,grid_share\n";
  appendSamples(csv, "in_plane", record.inPlane);
  appendSamples(csv, "full", record.full);
  return csv;
}

std::string toTable(const RunRecord& record) {
  Table table(record);
  addFigures(table, record);
  addStage(table, "in plane:", record.inPlane);
  addStage(table, "full:", record.full);
  addInverse(table, record);
  return table.text();
}

std::string toFigureTable(const RunRecord& record) {
  Table table(record);
  addFigures(table, record);
  return table.text();
}

}  // namespace morphgrid
