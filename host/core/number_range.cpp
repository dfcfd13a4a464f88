#include "core/number_range.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace morphgrid {
namespace {

std::string boundText(double bound) {
  if (std::abs(bound) == std::numbers::pi) return bound < 0 ? "-pi" : "pi";
  return fmt::format("{:g}", bound);
}

std::string joinBounds(const std::string& kind, const std::string& low, const std::string& high) {
  return kind + (low.empty() ? "" : " " + low) + (low.empty() || high.empty() ? "" : " and") +
         (high.empty() ? "" : " " + high);
}

}  // namespace

bool NumberRange::contains(double number) const {
  if (!std::isfinite(number)) return false;
  return (number > low || (lowIncluded && number == low)) &&
         (number < high || (highIncluded && number == high));
}

std::string describe(const NumberRange& range) {
  std::string low, high;
  if (std::isfinite(range.low)) low = (range.lowIncluded ? ">= " : "> ") + boundText(range.low);
  if (std::isfinite(range.high)) high = (range.highIncluded ? "<= " : "< ") + boundText(range.high);
  return low.empty() && high.empty() ? "a finite number" : joinBounds("a number", low, high);
}

std::string describe(const IntegerRange& range) {
  const IntegerRange all;
  return joinBounds("an integer", range.low == all.low ? "" : fmt::format(">= {}", range.low),
                    range.high == all.high ? "" : fmt::format("<= {}", range.high));
}

}  // namespace morphgrid
