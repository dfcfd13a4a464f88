#include "report/plot_axis.h"

#include <algorithm>
#include <cmath>

namespace morphgrid {
namespace {

constexpr int kMostSteps = 6;  // Labelled steps of a linear axis.
// Share of the largest value: a smaller range cannot be read off the numbers.
constexpr double kLeastRange = 1e-4;
// What is beyond, or closer to 0, takes arithmetic out of the range of double.
constexpr double kLargest = 1e300;
constexpr double kSmallest = 1e-300;

std::vector<double> decades(double low, double high) {
  const int first = static_cast<int>(std::floor(std::log10(low)));
  const int last = std::max(first + 1, static_cast<int>(std::ceil(std::log10(high))));
  std::vector<double> ticks;
  for (int decade = first; decade <= last; ++decade) {
    ticks.push_back(std::pow(10, decade));
  }
  return ticks;
}

/// 1, 2 or 5 times a power of ten, the shortest that needs no more than the most steps.
double roundStep(double range) {
  const double least = range / kMostSteps;
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1, 2, 5}) {
    if (factor * power >= least) {
      return factor * power;
    }
  }
  return 10 * power;
}

std::vector<double> steps(double low, double high) {
  const double size = std::max(std::abs(low), std::abs(high));
  const bool differ = high - low > std::max(kLeastRange * size, kSmallest);
  const double range = differ ? high - low : std::max(1.0, size);
  const double step = roundStep(range);
  const double first = std::floor(low / step);
  const double last = std::max(first + 1, std::ceil(high / step));
  std::vector<double> ticks;
  for (double n = first; n <= last; ++n) {
    ticks.push_back(n * step);
  }
  return ticks;
}

double placeOn(PlotScale scale, double value) {
  return scale == PlotScale::logarithmic ? std::log10(value) : value;
}

}  // namespace

bool canShow(PlotScale scale, double value) {
  return std::abs(value) <= kLargest && (scale == PlotScale::linear || value >= kSmallest);
}

PlotAxis::PlotAxis(PlotScale scale, const std::vector<double>& values) : scale_(scale) {
  std::vector<double> shown;
  std::copy_if(values.begin(), values.end(), std::back_inserter(shown),
               [&](double value) { return canShow(scale, value); });
  if (shown.empty()) {
    shown.push_back(1);
  }
  const auto [low, high] = std::minmax_element(shown.begin(), shown.end());
  ticks_ = scale == PlotScale::logarithmic ? decades(*low, *high) : steps(*low, *high);
}

double PlotAxis::share(double value) const {
  const double first = placeOn(scale_, ticks_.front());
  return (placeOn(scale_, value) - first) / (placeOn(scale_, ticks_.back()) - first);
}

}  // namespace morphgrid
