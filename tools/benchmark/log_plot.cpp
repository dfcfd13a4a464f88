#include "benchmark/log_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace morphgrid {
namespace {

// In pixels.
constexpr double kWidth = 720;
constexpr double kHeight = 480;
constexpr double kLeft = 80;
constexpr double kRight = 110;  // Room for the names of the series.
constexpr double kTop = 40;
constexpr double kBottom = 60;

// Told apart by those who do not see red and green apart too (Okabe & Ito 2008).
constexpr std::array kColors{"#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};

/// Whole decades.
struct Axis {
  int first = 1000;
  int last = -1000;

  void include(double value) {
    first = std::min(first, static_cast<int>(std::floor(std::log10(value))));
    last = std::max(last, static_cast<int>(std::ceil(std::log10(value))));
    last = std::max(last, first + 1);
  }
  double share(double value) const { return (std::log10(value) - first) / (last - first); }
};

class Drawing {
 public:
  explicit Drawing(const LogPlot& plot) : plot_(plot) {
    for (const auto& [name, points] : plot.series) {
      for (const LogPoint& point : points) {
        xAxis_.include(point.x);
        yAxis_.include(point.y);
      }
    }
  }

  std::string svg() {
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" font-family=\"sans-serif\" font-size=\"14\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        kWidth, kHeight);
    drawAxes();
    std::size_t n = 0;
    for (auto [name, points] : plot_.series) {
      std::sort(points.begin(), points.end(),
                [](const LogPoint& a, const LogPoint& b) { return a.x < b.x; });
      drawSeries(name, points, kColors[n++ % kColors.size()]);
    }
    return text_ + "</svg>\n";
  }

 private:
  double xOf(double x) const { return kLeft + xAxis_.share(x) * (kWidth - kLeft - kRight); }
  double yOf(double y) const {
    return kHeight - kBottom - yAxis_.share(y) * (kHeight - kTop - kBottom);
  }

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

  void drawAxes() {
    for (int decade = xAxis_.first; decade <= xAxis_.last; ++decade) {
      const double x = xOf(std::pow(10, decade));
      line(x, kTop, x, kHeight - kBottom, "#dddddd", 1);
      label(x, kHeight - kBottom + 20, fmt::format("{:g}", std::pow(10, decade)), "middle");
    }
    for (int decade = yAxis_.first; decade <= yAxis_.last; ++decade) {
      const double y = yOf(std::pow(10, decade));
      line(kLeft, y, kWidth - kRight, y, "#dddddd", 1);
      label(kLeft - 8, y + 5, fmt::format("{:g}", std::pow(10, decade)), "end");
    }
    const double middleX = (kLeft + kWidth - kRight) / 2;
    const double middleY = (kTop + kHeight - kBottom) / 2;
    label(middleX, 24, plot_.title, "middle", " font-weight=\"bold\"");
    label(middleX, kHeight - 16, plot_.xLabel, "middle");
    label(20, middleY, plot_.yLabel, "middle",
          fmt::format(" transform=\"rotate(-90 20 {:.1f})\"", middleY));
  }

  void drawSeries(const std::string& name, const std::vector<LogPoint>& points, const char* color) {
    for (std::size_t n = 0; n < points.size(); ++n) {
      const double x = xOf(points[n].x);
      const double y = yOf(points[n].y);
      if (n > 0) {
        line(xOf(points[n - 1].x), yOf(points[n - 1].y), x, y, color, 2);
      }
      if (points[n].atLeast) {
        line(x, y, x, y - 18, color, 2);
        line(x - 4, y - 13, x, y - 18, color, 2);
        line(x + 4, y - 13, x, y - 18, color, 2);
      }
    }
    for (const LogPoint& point : points) {
      text_ += fmt::format(
          "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\" fill=\"{}\" stroke=\"{}\" "
          "stroke-width=\"2\"/>\n",
          xOf(point.x), yOf(point.y), point.atLeast ? "white" : color, color);
    }
    label(xOf(points.back().x) + 10, freeLine(yOf(points.back().y) + 5), name, "start",
          fmt::format(" fill=\"{}\"", color));
  }

  /// The nearest y at or below the wanted one where no name stands yet.
  double freeLine(double wanted) {
    constexpr double kLineHeight = 16;
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

  const LogPlot& plot_;
  Axis xAxis_;
  Axis yAxis_;
  std::string text_;
  std::vector<double> nameLines_;  ///< y of the names so far.
};

}  // namespace

std::string toSvg(const LogPlot& plot) { return Drawing(plot).svg(); }

}  // namespace morphgrid
