#pragma once
#include <string>
#include <utility>
#include <vector>

namespace morphgrid {

struct PlotPoint {
  double x;
  double y;
  bool atLeast = false;  ///< y is only a lower bound: drawn hollow, with an arrow.
};

enum class PlotScale { linear, logarithmic };

struct PlotSeries {
  std::string name;
  std::vector<PlotPoint> points;  ///< In any order: they are joined in that of x.
};

struct PlotPanel {
  std::string yLabel;
  PlotScale yScale;
  std::vector<PlotSeries> series;
};

/// Diagrams above each other that share their x axis.
struct Plot {
  std::string title;
  std::string xLabel;
  PlotScale xScale;
  std::vector<PlotPanel> panels;
};

/// An SVG file. Points that are not finite, or not positive on a logarithmic axis, are left out.
/// Texts are taken as they are: they must not hold <, > or &.
std::string toSvg(const Plot& plot);

}  // namespace morphgrid
