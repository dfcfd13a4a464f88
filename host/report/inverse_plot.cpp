#include "report/inverse_plot.h"

#include "report/plot.h"

namespace morphgrid {
namespace {

PlotSeries seriesOf(const char* name, const InverseDesign& inverse, double InverseStep::*figure) {
  PlotSeries series{name, {}};
  for (std::size_t n = 0; n < inverse.steps.size(); ++n) {
    series.points.push_back({static_cast<double>(n), inverse.steps[n].*figure});
  }
  return series;
}

}  // namespace

std::string toInversePlot(const InverseDesign& inverse, double maxShrinkage) {
  PlotSeries allowed = seriesOf("allowed", inverse, &InverseStep::largestShrinkPercent);
  for (PlotPoint& point : allowed.points) {
    point.y = 100 * maxShrinkage;
  }
  return toSvg({"Inverse design",
                "step: 0 the design, then spring-back correction, then optimisation",
                PlotScale::linear,
                {{"distance, % of the diagonal",
                  PlotScale::logarithmic,
                  {seriesOf("max", inverse, &InverseStep::maxPercent),
                   seriesOf("RMS", inverse, &InverseStep::rmsPercent)}},
                 {"largest shrink, %",
                  PlotScale::linear,
                  {std::move(allowed),
                   seriesOf("asked for", inverse, &InverseStep::largestShrinkPercent)}}}});
}

}  // namespace morphgrid
