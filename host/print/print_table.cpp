#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "print/print_record.h"

namespace morphgrid {
namespace {

class PrintRows {
 public:
  template <typename... Values>
  void row(const char* what, fmt::format_string<Values...> format, Values&&... values) {
    text_ +=
        fmt::format("  {:<26}{}\n", what, fmt::format(format, std::forward<Values>(values)...));
  }
  void line(const std::string& text) { text_ += text + '\n'; }
  void add(const std::string& rows) { text_ += rows; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void addSettings(PrintRows& rows, const PrintPlan& plan) {
  const PrintMaterial& material = plan.material;
  rows.row("printer", "{}", plan.printer.name);
  rows.row("material", "{}: {:+.1f} % along, {:+.1f} % across", material.name,
           100 * material.along.change, 100 * material.across.change);
  rows.row("  source", "{} ({})", material.source, material.year);
  rows.row("  caveat", "{}", material.caveat);
  rows.row("  bath", "{:g} degrees C", material.bath);
}

void addSizes(PrintRows& rows, const PrintPlan& plan) {
  const LayFigures& figures = plan.figures;
  rows.row("scale", "{:g} mm per unit", plan.scale);
  rows.row("sheet enlarged by", "{:.3f}", plan.enlargement);
  rows.row("on the bed", "{:.1f} x {:.1f} mm, turned by {} deg", plan.placing.extent.x(),
           plan.placing.extent.y(), plan.placing.degrees);
  rows.row("tiers, passes", "{}, {} x {:g} mm", plan.shape.layers, plan.material.strut.passes,
           plan.material.strut.passHeight);
  rows.row("struts", "{:.2f} / {:.2f} / {:.2f} mm (least, median, most)", figures.shortest,
           figures.median, figures.longest);
  rows.row("  width, height", "{:.2f} x {:.2f} mm", plan.strutWidth(), plan.heights.strut);
  rows.row("hubs", "{:.2f} mm, holes of {:.2f} mm", plan.hub.diameter, plan.hub.hole);
  if (plan.shape.layers > 1) {
    rows.row("tier spacing, tubes", "{:.2f} mm after the bath, {:.2f} mm printed",
             plan.heights.spacing, plan.heights.tube);
    rows.row("pins", "{} of {:.2f} mm, through {:.2f} mm", plan.shape.layerVertexCount(),
             plan.request.pin, stackHeight(plan));
  }
}

void addRange(PrintRows& rows, const PrintPlan& plan) {
  constexpr std::size_t kNamed = 3;
  const LayFigures& figures = plan.figures;
  rows.row("laid across, mean", "{:.0f} %", 100 * figures.meanShareAcross);
  rows.row("struts out of range", "{} of {}", figures.outOfRange.size(), figures.struts);
  for (std::size_t n = 0; n < std::min(kNamed, figures.outOfRange.size()); ++n) {
    const StrutOutOfRange& strut = figures.outOfRange[n];
    rows.row("", "{}: {:.1f} %, can {:.1f} to {:.1f} %", nameOf(plan.shape, strut.strut),
             100 * strut.wanted, 100 * strut.bounds.least, 100 * strut.bounds.most);
  }
  rows.row("rounded zones", "{} struts, {:.2f} % of a length at most", figures.rounded,
           100 * figures.largestRounding);
}

std::string hours(double seconds) {
  const long minutes = std::lround(seconds / 60);
  return fmt::format("{} h {:02}", minutes / 60, minutes % 60);
}

void addTiers(PrintRows& rows, const PrintRecord& record) {
  double seconds = 0;
  double grams = 0;
  double laid = 0;
  for (std::size_t n = 0; n < record.tiers.size(); ++n) {
    const TierFigures& tier = record.tiers[n];
    rows.row(fmt::format("tier {}", n + 1).c_str(), "{:.1f} m, {:.1f} g, {}; {} passes",
             tier.laidMm() / 1000, tier.grams, hours(tier.seconds), tier.passes);
    seconds += tier.seconds;
    grams += tier.grams;
    laid += tier.laidMm();
  }
  rows.row("all tiers", "{:.1f} m, {:.1f} g, {}", laid / 1000, grams, hours(seconds));
}

void addShape(PrintRows& rows, const LaidShape& shape) {
  rows.row(shape.hasTarget ? "distance to the target" : "distance to design's end",
           "RMS / max, by the model {}", shape.model);
  rows.row("  as designed", "{:.3g} / {:.3g} %", shape.designRmsPercent, shape.designMaxPercent);
  rows.row("  as laid", "{:.3g} / {:.3g} %", shape.laidRmsPercent, shape.laidMaxPercent);
  if (shape.fromFlatRmsPercent) {
    rows.row("  as laid, from flat", "{:.3g} %{}", *shape.fromFlatRmsPercent,
             shape.endsThereFromFlat ? "" : ", another equilibrium");
  }
}

}  // namespace

std::string printTable(const PrintRecord& record) {
  PrintRows rows;
  rows.line(record.plan.name + ", to be printed");
  addSettings(rows, record.plan);
  addSizes(rows, record.plan);
  addRange(rows, record.plan);
  addTiers(rows, record);
  if (record.shape) addShape(rows, *record.shape);
  if (record.tolerance) rows.add(toleranceTable(*record.tolerance));
  return rows.text();
}

}  // namespace morphgrid
