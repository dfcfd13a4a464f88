#include "report/report_table.h"

#include <fmt/format.h>

#include <cmath>

#include "core/visible_text.h"
#include "report/degrees.h"
#include "surface/box_text.h"

namespace morphgrid {
namespace {

/// Rows of "what, ours, the paper's".
class Table {
 public:
  explicit Table(const RunRecord& record) : published_(record.published) {
    text_ = fmt::format("{:<26}{:>16}", visibleText(record.title), "morphgrid");
    if (published_) {
      text_ += fmt::format("{:>16}", "paper " + visibleText(published_->figure));
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
  std::string text() const { return visibleText(text_, "\n"); }

 private:
  const std::optional<PublishedFigures>& published_;
  std::string text_;
};

/// Two digits behind the point, or two at all of what is smaller than a tenth.
std::string digitsOf(double percent) {
  return std::abs(percent) < 0.1 ? fmt::format("{:.2g}", percent) : fmt::format("{:.2f}", percent);
}

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

void addSheet(Table& table, const RunRecord& record) {
  if (!record.sheet) {
    return;
  }
  const SheetFigures& s = *record.sheet;
  table.row("sheet", fmt::format("{:.4g} x {:.4g}", s.sizeX, s.sizeY));
  table.row("  angle off, mean / max",
            fmt::format("{:.2f} / {:.1f} deg", degrees(s.meanAngle), degrees(s.largestAngle)));
  table.row("  twist, mean / max",
            fmt::format("{:.1f} / {:.1f} deg", degrees(s.meanTwist), degrees(s.largestTwist)));
  table.row("  scale varies by", fmt::format("{:.3g}", s.scaleRatio));
  table.row("  struts out of range", fmt::format("{}", s.strutsOutOfRange));
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
    table.line("  a box without holes:\n" + boxAsToml(*m.suggestedBox));
  }
}

std::string counted(long iterations) {
  return fmt::format("{} {}", iterations, iterations == 1 ? "iteration" : "iterations");
}

void addStage(Table& table, const char* name, const std::optional<Equilibrium>& stage) {
  if (!stage || stage->reason == StopReason::laidOut) {
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
    if (record.shrink->strutsUnderLeast != record.shrink->strutsGrowing) {
      rowIfAny("struts under the least", record.shrink->strutsUnderLeast);
    }
  }
  if (record.feasibility) {
    const Feasibility& f = *record.feasibility;
    rowIfAny("inverted cells", f.cells.inverted);
    rowIfAny("collapsed cells", f.cells.collapsed);
    rowIfAny("self-intersecting cells", f.selfIntersection.cells);
    rowIfAny("struts too close", f.closeStruts ? f.closeStruts->count : 0);
  }
}

const char* outcomeOf(const FromFlat& check) {
  if (!check.isSettled) return "NOT at rest: unknown";
  return check.sameEquilibrium ? "the design's equilibrium" : "ANOTHER equilibrium";
}

/// Of what comes from the printer.
void addPrintedSheet(Table& table, const RunRecord& record) {
  if (!record.printedSheet) return;
  const Eigen::Array2d& size = *record.printedSheet;
  table.row("printed sheet, x by y", fmt::format("{:.4g} x {:.4g}", size.x(), size.y()));
  if (const auto mm = record.printedSheetMm()) {
    table.row("  in mm", fmt::format("{:.1f} x {:.1f}", mm->x(), mm->y()));
    table.row("  mm per unit", fmt::format("{:g}", record.print->scale));
  }
}

void addInverse(Table& table, const RunRecord& record) {
  if (record.printScale != 1) {
    table.line(fmt::format("  printed {:.3f} times as large as the in-plane stage left the sheet",
                           record.printScale));
  }
  if (record.beforeInverse) {
    table.line(fmt::format("  full:     {}, {:.2f} s", counted(record.beforeInverse->iterations),
                           record.beforeInverse->seconds));
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
  // Its own time and iterations are those of the last step.
  if (record.inverse) addStage(table, "its end:", record.full);
  if (record.inverse && record.inverse->fromFlat) {
    const FromFlat& check = *record.inverse->fromFlat;
    table.line(fmt::format("  check from flat: {} cycles ({}), distance {:.3g} %, {:.2f} s",
                           check.cycles, outcomeOf(check), check.rmsPercent, check.seconds));
  }
}

void addResults(Table& table, const RunRecord& record, const PublishedFigures& paper) {
  const auto percent = [](double value) { return digitsOf(value) + " %"; };
  if (record.errors) {
    table.row("L0 error", percent(record.errors->l0Percent), ifAll("{:.2f} %", paper.l0Percent));
    table.row("L_b error", percent(record.errors->lbPercent), ifAll("{:.2f} %", paper.lbPercent));
    table.row("angle error", percent(record.errors->anglePercent),
              ifAll("{:.2f} %", paper.anglePercent));
  }
  if (record.distance) {
    const TargetDistance& d = *record.distance;
    const auto pair = [](double mean, double largest) {
      return fmt::format("{} / {} %", digitsOf(mean), digitsOf(largest));
    };
    table.row("distance, RMS / max", pair(d.rmsPercent, d.maxPercent));
    if (d.closest) {
      table.row("  to closest point", pair(d.closest->rmsPercent, d.closest->maxPercent));
    }
  }
  if (record.shrink) {
    table.row("largest shrink", percent(record.shrink->largestPercent));
    if (record.strain) table.row("largest strain", percent(record.strain->largestPercent));
    table.row("struts over the limit", fmt::format("{}", record.shrink->strutsOverLimit));
  }
  if (record.weight) {
    const WeightFigures& w = *record.weight;
    table.row("weight", fmt::format("{:.3g} N", w.newtons));
    if (w.sag) table.row("  sags by", fmt::format("{:.3g}", *w.sag));
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
  table.row("model", record.model, record.model == "paper" ? "" : "paper");
  table.row("vertices, struts", fmt::format("{}, {}", g.shape.vertexCount(), g.shape.strutCount()));
  table.row("largest L_b shrink", fmt::format("{:.1f} %", g.bendShrinkPercent),
            ifAll("{:.1f} %", paper.bendShrinkPercent));
  addNet(table, record);
  addSheet(table, record);
  addPrintedSheet(table, record);
  addCutoffs(table, record);
  addResults(table, record, paper);
}

}  // namespace

std::string toTable(const RunRecord& record) {
  Table table(record);
  addFigures(table, record);
  if (record.sheet) {
    table.line(fmt::format("  {:<9} {}, {:.2f} s", "layout:", counted(record.sheet->iterations),
                           record.sheet->seconds));
  }
  addStage(table, "in plane:", record.inPlane);
  if (!record.inverse) addStage(table, "full:", record.full);
  addInverse(table, record);
  return table.text();
}

std::string toFigureTable(const RunRecord& record) {
  Table table(record);
  addFigures(table, record);
  return table.text();
}

}  // namespace morphgrid
