#include "report/read_report.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "core/error.h"
#include "report/degrees.h"

namespace morphgrid {
namespace {

using nlohmann::json;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

double number(const json& value) { return value.get<double>(); }

/// What is not finite was written as null.
double numberOr(double nonFinite, const json& value) {
  return value.is_null() ? nonFinite : number(value);
}

std::optional<double> optionalNumber(const json& value) {
  return value.is_null() ? std::nullopt : std::optional(number(value));
}

template <typename Integer = int>
Integer integer(const json& value) {
  const auto wide = value.is_number_integer() ? value.get<std::int64_t>() : -1;
  if (wide < 0 || !std::in_range<Integer>(wide)) {
    throw std::out_of_range("no count");
  }
  return static_cast<Integer>(wide);
}

std::string toString(NetKind kind) { return nameOf(kind); }

/// The choice of that name.
template <typename Choice>
Choice choose(std::initializer_list<Choice> choices, const json& name) {
  for (const Choice choice : choices) {
    if (toString(choice) == name.get_ref<const std::string&>()) return choice;
  }
  throw std::out_of_range("no such name");
}

template <typename Read>
auto optionally(Read read, const json& value) {
  return value.is_null() ? std::nullopt : std::optional(read(value));
}

GridFigures readGrid(const json& g) {
  const GridShape shape{integer(g.at("nodes_u")) + 1, integer(g.at("nodes_v")) + 1,
                        integer(g.at("layers"))};
  return {shape, number(g.at("spacing")), number(g.at("layer_spacing")),
          number(g.at("bend_shrink_percent"))};
}

NetFigures readNet(const json& n) {
  using enum NetKind;
  return {choose({isoline, orthogonal, principal}, n.at("kind")),
          optionalNumber(n.at("modulus")),
          number(n.at("blend")),
          {numberOr(kInfinity, n.at("strut_ratio")),
           radians(number(n.at("mean_angle_deviation_degrees"))),
           radians(number(n.at("largest_angle_deviation_degrees")))}};
}

MeshFigures readMesh(const json& m) {
  MeshFigures figures;
  figures.file = m.at("file");
  figures.triangles = integer(m.at("triangles"));
  figures.rays = integer(m.at("rays"));
  figures.missed = integer(m.at("missed"));
  figures.largestJump = number(m.at("largest_jump"));
  figures.secondsBuild = number(m.at("seconds_build"));
  figures.secondsRays = number(m.at("seconds_rays"));
  return figures;
}

MeasurementFigures readMeasurement(const json& m) {
  std::vector<CutoffConsequence> cutoffs;
  for (const json& c : m.at("cutoffs")) {
    cutoffs.push_back({number(c.at("p")), number(c.at("curvature")),
                       numberOr(kInfinity, c.at("layer_spacing_limit")),
                       number(c.at("fewest_nodes"))});
  }
  return {number(m.at("longest_isoline_u")),
          number(m.at("longest_isoline_v")),
          number(m.at("largest_curvature")),
          numberOr(kInfinity, m.at("layer_spacing_limit")),
          integer(m.at("fewest_nodes")),
          std::move(cutoffs),
          optionalNumber(m.at("suggested_cutoff")),
          optionalNumber(m.at("curvature_noise"))};
}

SmallestEigenvalue readEigenvalue(const json& e) {
  SmallestEigenvalue eigenvalue;
  eigenvalue.value = numberOr(kNoNumber, e.at("value"));
  eigenvalue.residual = numberOr(kNoNumber, e.at("residual"));
  eigenvalue.iterations = integer<long>(e.at("iterations"));
  eigenvalue.converged = e.at("converged").get<bool>();
  eigenvalue.seconds = number(e.at("seconds"));
  return eigenvalue;
}

Equilibrium readEquilibrium(const json& e) {
  using enum StopReason;
  Equilibrium stage;
  stage.iterations = integer<long>(e.at("iterations"));
  stage.converged = e.at("converged").get<bool>();
  stage.reason =
      choose({residual, energy, iterationLimit, stagnated, interrupted, deviceFailure, laidOut},
             e.at("reason"));
  stage.residual = numberOr(kNoNumber, e.at("residual"));
  stage.energy = numberOr(kNoNumber, e.at("energy"));
  stage.seconds = number(e.at("seconds"));
  stage.smallestEigenvalue = optionally(readEigenvalue, e.at("smallest_eigenvalue"));
  return stage;
}

SheetFigures readSheet(const json& s) {
  return {.meanAngle = radians(number(s.at("mean_angle_error_degrees"))),
          .largestAngle = radians(number(s.at("largest_angle_error_degrees"))),
          .scaleRatio = number(s.at("scale_ratio")),
          .lateralStruts = integer(s.at("lateral_struts")),
          .strutsOutOfRange = integer(s.at("struts_out_of_range")),
          .barsBeyondRange = integer(s.at("net_struts_beyond_range")),
          .meanTwist = radians(number(s.at("mean_twist_degrees"))),
          .largestTwist = radians(number(s.at("largest_twist_degrees"))),
          .sizeX = number(s.at("size_x")),
          .sizeY = number(s.at("size_y")),
          .fittingLayerSpacing =
              numberOr(std::numeric_limits<double>::infinity(), s.at("fitting_layer_spacing")),
          .iterations = integer(s.at("iterations")),
          .seconds = number(s.at("seconds"))};
}

InverseStep readStep(const json& s) {
  using enum InverseStep::Kind;
  return {choose({design, compensate, optimise}, s.at("kind")),
          integer(s.at("number")),
          number(s.at("rms_percent")),
          number(s.at("max_percent")),
          number(s.at("largest_shrink_percent")),
          numberOr(kNoNumber, s.value("largest_strain_percent", json())),
          integer<long>(s.at("struts_at_bound")),
          integer<long>(s.at("cycles")),
          integer(s.at("adjoint_products")),
          number(s.at("seconds"))};
}

FromFlat readFromFlat(const json& f) {
  return {f.at("same_equilibrium").get<bool>(), number(f.at("rms_percent")),
          optionally(number, f.value("least_eigenvalue_ratio", json())),
          // Runs of before have none of these.
          f.value("settled", true), integer<long>(f.value("cycles", json(0))),
          number(f.value("seconds", json(0.0)))};
}

StageEffort readEffort(const json& e) {
  return {integer<long>(e.at("iterations")), number(e.at("seconds"))};
}

InverseDesign readInverse(const json& i) {
  InverseDesign inverse;
  for (const json& step : i.at("steps")) {
    inverse.steps.push_back(readStep(step));
  }
  if (inverse.steps.empty()) {
    throw std::out_of_range("the design is a step, too");
  }
  inverse.ending = i.at("ending");
  inverse.fromFlat = optionally(readFromFlat, i.at("from_flat"));
  inverse.refusedAsSoft = i.value("steps_refused_as_soft", 0);
  return inverse;
}

SymmetryFigures readSymmetry(const json& s) {
  using enum Symmetry;
  return {choose({mirrorAcrossU, mirrorAcrossV, halfTurn}, s.at("kind")),
          number(s.at("target_percent")), number(s.at("result_percent"))};
}

StrutErrors readErrors(const json& e) {
  return {number(e.at("l0_percent")), number(e.at("lb_percent")), number(e.at("angle_percent"))};
}

/// prefix: of its keys.
DistanceSpread readSpread(const json& d, const std::string& prefix) {
  DistanceSpread spread;
  spread.medianPercent = number(d.at(prefix + "median_percent"));
  spread.percentile90 = number(d.at(prefix + "percentile_90_percent"));
  spread.percentile99 = number(d.at(prefix + "percentile_99_percent"));
  const json& histogram = d.at(prefix + "histogram");
  spread.binPercent = number(histogram.at("bin_percent"));
  for (std::size_t bin = 0; bin < spread.counts.size(); ++bin) {
    spread.counts[bin] = integer(histogram.at("counts").at(bin));
  }
  return spread;
}

TargetDistance readDistance(const json& d) {
  TargetDistance distance{number(d.at("rms_percent")),
                          number(d.at("max_percent")),
                          readSpread(d, ""),
                          std::nullopt,
                          number(d.value("diagonal", json(0.0))),  // Runs of before have none.
                          number(d.value("axis_parallel_diagonal", json(0.0)))};
  if (d.contains("closest_point_rms_percent")) {  // Runs that were interrupted have none.
    distance.closest = {number(d.at("closest_point_rms_percent")),
                        number(d.at("closest_point_max_percent")), readSpread(d, "closest_point_")};
  }
  return distance;
}

ShrinkCounts readShrinkCounts(const json& s) {
  return {number(s.at("largest_percent")),        integer(s.at("struts_over_limit")),
          integer(s.at("struts_at_limit")),       integer(s.at("struts_growing")),
          number(s.at("largest_growth_percent")), s.value("struts_under_least", 0)};
}

ShrinkFigures readShrink(const json& s) {
  ShrinkFigures shrink{readShrinkCounts(s), {}};
  for (const json& layer : s.at("layers")) {
    shrink.layers.push_back(readShrinkCounts(layer));
  }
  return shrink;
}

StrainFigures readStrain(const json& s) {
  return {number(s.at("largest_percent")), number(s.at("mean_percent")),
          integer(s.at("struts_over_limit"))};
}

WeightFigures readWeight(const json& w) {
  return {number(w.at("newtons")), optionalNumber(w.at("sag"))};
}

GridPlace readPlace(const json& p) {
  return {integer(p.at(0)), integer(p.at(1)), integer(p.at(2))};
}

CloseStruts readCloseStruts(const json& c) {
  const double thickness = number(c.at("thickness"));
  return {thickness, integer(c.at("count")), numberOr(thickness, c.at("smallest_clearance")),
          optionally(readPlace, c.at("closest")).value_or(GridPlace{})};
}

Feasibility readFeasibility(const json& f) {
  return {{integer(f.at("inverted_cells")), integer(f.at("collapsed_cells")),
           number(f.at("smallest_relative_area")), readPlace(f.at("smallest_cell"))},
          {integer(f.at("self_intersecting_cells")),
           optionally(readPlace, f.at("first_self_intersection")).value_or(GridPlace{})},
          optionally(readCloseStruts, f.at("close_struts"))};
}

Eigen::Array2d readPrintedSheet(const json& s) {
  const json& size = s.at("size");
  return {number(size.at(0)), number(size.at(1))};
}

BarSizes readBars(const json& b) {
  return {number(b.at("width")), number(b.at("height")), number(b.at("post")),
          number(b.at("joint"))};
}

PrintAssessment readPrint(const json& p) {
  PrintAssessment print{.printer = p.at("printer"),
                        .material = p.at("material"),
                        .printerDigest = p.value("printer_digest", ""),
                        .materialDigest = p.value("material_digest", ""),
                        .scale = number(p.at("scale_mm_per_unit")),
                        .enlargement = number(p.at("enlargement")),
                        .obstacles = {}};
  for (const json& obstacle : p.at("obstacles")) {
    print.obstacles.push_back({obstacle.at("what"), obstacle.at("way_out")});
  }
  return print;
}

RunRecord readRecord(const json& r) {
  RunRecord record;
  record.scene = r.at("scene");
  record.title = r.at("title");
  record.method = r.at("method");
  record.scaling = r.at("scaling");
  record.model = r.value("model", record.model);  // There was one model before.
  record.device = r.at("device");
  record.secondsTotal = number(r.at("seconds_total"));
  record.grid = readGrid(r.at("grid"));
  record.net = optionally(readNet, r.at("net"));
  record.mesh = optionally(readMesh, r.at("mesh"));
  record.measurement = optionally(readMeasurement, r.at("measurement"));
  // Reports of before have none of these.
  record.sheet = optionally(readSheet, r.value("sheet", json()));
  record.strain = optionally(readStrain, r.value("strain", json()));
  record.weight = optionally(readWeight, r.value("weight", json()));
  record.printedSheet = optionally(readPrintedSheet, r.value("printed_sheet", json()));
  record.bars = optionally(readBars, r.value("bars", json()));
  record.print = optionally(readPrint, r.value("print", json()));
  record.inPlane = optionally(readEquilibrium, r.at("in_plane"));
  record.printScale = number(r.at("print_scale"));
  record.full = optionally(readEquilibrium, r.at("full"));
  record.beforeInverse = optionally(readEffort, r.value("before_inverse_design", json()));
  record.inverse = optionally(readInverse, r.at("inverse_design"));
  record.errors = optionally(readErrors, r.at("errors"));
  record.distance = optionally(readDistance, r.at("distance_to_target"));
  record.symmetry = optionally(readSymmetry, r.value("symmetry", json()));
  record.shrink = optionally(readShrink, r.at("shrink"));
  record.isInterrupted = r.value("interrupted", false);  // Runs of before do not say.
  record.feasibility = optionally(readFeasibility, r.at("feasibility"));
  if (!r.at("device_failure").is_null()) {
    record.deviceFailure = r.at("device_failure").get<std::string>();
  }
  const auto notices = r.at("notices").get<std::vector<std::string>>();
  record.notices.assign(notices.begin(), notices.end());
  return record;
}

}  // namespace

RunRecord readReport(std::string_view text) {
  try {
    return readRecord(json::parse(text));
  } catch (const json::exception& error) {
    throw InputError(fmt::format("no report of a run: {}", error.what()));
  } catch (const std::out_of_range& error) {
    throw InputError(fmt::format("no report of a run: {}", error.what()));
  }
}

}  // namespace morphgrid
