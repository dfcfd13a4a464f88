#include "report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report/plot_axis.h"

namespace morphgrid {
namespace {

// In pixels.
constexpr double kWidth = 720;
constexpr double kLeft = 80;
constexpr double kRight = 110;  // Room for the names of the series.
constexpr double kTop = 40;
constexpr double kBottom = 60;
constexpr double kPanel = 380;       // The height of one alone ...
constexpr double kSmallPanel = 200;  // ... and of one among others.
constexpr double kGap = 24;
constexpr double kLineHeight = 16;

constexpr std::size_t kFewPoints = 12;  // Series of at most so many points get large dots.

// Colours that people who cannot see red and green apart can tell apart too (Okabe & Ito 2008).
constexpr std::array kSeriesColors{"#d55e00", "#0072b2", "#009e73",
                                   "#cc79a7", "#e69f00", "#56b4e9"};

PlotAxis xAxisOf(const Plot& plot) {
  std::vector<double> values;
  for (const PlotPanel& panel : plot.panels) {
    for (const PlotSeries& series : panel.series) {
      for (const PlotPoint& point : series.points) {
        values.push_back(point.x);
      }
    }
  }
  return {plot.xScale, values};
}

PlotAxis yAxisOf(const PlotPanel& panel) {
  std::vector<double> values;
  for (const PlotSeries& series : panel.series) {
    for (const PlotPoint& point : series.points) {
      values.push_back(point.y);
    }
  }
  return {panel.yScale, values};
}

class SvgPlot {
 public:
  explicit SvgPlot(const Plot& plot)
      : plot_(plot),
        xAxis_(xAxisOf(plot)),
        panelHeight_(plot.panels.size() > 1 ? kSmallPanel : kPanel) {}

  std::string draw() {
    const auto count = static_cast<double>(plot_.panels.size());
    const double height = kTop + count * panelHeight_ + (count - 1) * kGap + kBottom;
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" font-family=\"sans-serif\" font-size=\"14\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        kWidth, height);
    const double middle = (kLeft + kWidth - kRight) / 2;
    label(middle, 24, plot_.title, "middle", " font-weight=\"bold\"");
    label(middle, height - 16, plot_.xLabel, "middle");
    std::size_t colors = 0;
    double top = kTop;
    for (const PlotPanel& panel : plot_.panels) {
      const bool last = &panel == &plot_.panels.back();
      drawPanel(panel, top, last, colors);
      colors += panel.series.size();
      top += panelHeight_ + kGap;
    }
    return text_ + "</svg>\n";
  }

 private:
  double xOf(double x) const { return kLeft + xAxis_.share(x) * (kWidth - kLeft - kRight); }

  void line(double x1, double y1, double x2, double y2, const char* color, double width) {
    text_ += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
        "stroke-width=\"{}\"/>\n",
        x1, y1, x2, y2, color, width);
  }

  void label(double x, double y, const std::string& words, const char* anchor,
             const std::string& more = {}) {
    text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                         anchor, more, words);
  }

  void drawPanel(const PlotPanel& panel, double top, bool withNumbersOfX, std::size_t colors) {
    const double bottom = top + panelHeight_;
    const PlotAxis yAxis = yAxisOf(panel);
    const auto yOf = [&](double y) { return bottom - yAxis.share(y) * panelHeight_; };
    for (const double tick : xAxis_.ticks()) {
      line(xOf(tick), top, xOf(tick), bottom, "#dddddd", 1);
      if (withNumbersOfX) {
        label(xOf(tick), bottom + 20, fmt::format("{:g}", tick), "middle");
      }
    }
    for (const double tick : yAxis.ticks()) {
      line(kLeft, yOf(tick), kWidth - kRight, yOf(tick), "#dddddd", 1);
      label(kLeft - 8, yOf(tick) + 5, fmt::format("{:g}", tick), "end");
    }
    const double middle = (top + bottom) / 2;
    label(20, middle, panel.yLabel, "middle",
          fmt::format(" transform=\"rotate(-90 20 {:.1f})\"", middle));
    nameLines_.clear();
    for (const PlotSeries& series : panel.series) {
      drawSeries(series.name, placed(series, panel.yScale, yOf),
                 kSeriesColors[colors++ % kSeriesColors.size()]);
    }
  }

  /// In pixels, without the points that have no place.
  template <typename YOf>
  std::vector<PlotPoint> placed(const PlotSeries& series, PlotScale yScale, const YOf& yOf) const {
    std::vector<PlotPoint> points;
    for (const PlotPoint& point : series.points) {
      if (canShow(plot_.xScale, point.x) && canShow(yScale, point.y)) {
        points.push_back({xOf(point.x), yOf(point.y), point.atLeast});
      }
    }
    std::sort(points.begin(), points.end(),
              [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
    return points;
  }

  void drawSeries(const std::string& name, const std::vector<PlotPoint>& points,
                  const char* color) {
    if (points.empty()) {
      return;
    }
    for (std::size_t n = 0; n < points.size(); ++n) {
      const auto& [x, y, atLeast] = points[n];
      if (n > 0) {
        line(points[n - 1].x, points[n - 1].y, x, y, color, 2);
      }
      if (atLeast) {
        line(x, y, x, y - 18, color, 2);
        line(x - 4, y - 13, x, y - 18, color, 2);
        line(x + 4, y - 13, x, y - 18, color, 2);
      }
    }
    for (const auto& [x, y, atLeast] : points) {
      text_ += fmt::format(
          "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\" stroke=\"{}\" "
          "stroke-width=\"2\"/>\n",
          x, y, points.size() > kFewPoints ? 1.5 : 4.5, atLeast ? "white" : color, color);
    }
    label(points.back().x + 10, freeLine(points.back().y + 5), name, "start",
          fmt::format(" fill=\"{}\"", color));
  }

  /// The nearest y at or below the wanted one where no name stands yet.
  double freeLine(double wanted) {
    double y = wanted;
    for (bool taken = true; taken;) {
      taken = false;
      for (const double other : nameLines_) {
        if (std::abs(other - y) < kLineHeight) {
          y = other + kLineHeight;
          taken = true;
        }
      }
    }
    nameLines_.push_back(y);
    return y;
  }

  const Plot& plot_;
  PlotAxis xAxis_;
  double panelHeight_;
  std::string text_;
  std::vector<double> nameLines_;  ///< y of the names so far in a panel.
};

}  // namespace

std::string toSvg(const Plot& plot) { return SvgPlot(plot).draw(); }

}  // namespace morphgrid
