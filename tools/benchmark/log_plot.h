#pragma once
#include <map>
#include <string>
#include <vector>

namespace morphgrid {

struct LogPoint {
  double x;      ///< > 0
  double y;      ///< > 0
  bool atLeast;  ///< y is only a lower bound: drawn hollow, with an arrow.
};

/// A diagram with logarithmic axes.
struct LogPlot {
  std::string title;
  std::string xLabel;
  std::string yLabel;
  std::map<std::string, std::vector<LogPoint>> series;  ///< By name; at least one point in all.
};

std::string toSvg(const LogPlot& plot);

}  // namespace morphgrid
