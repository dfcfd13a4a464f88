#include "core/decimals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace morphgrid {
namespace {

// A double has no more digits; tiny numbers are written in full.
constexpr int kMostDecimals = 15;

}  // namespace

int decimalsFor(double step) {
  return std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
}

double roundedTo(double value, int decimals) {
  return std::strtod(inDecimals(value, decimals).c_str(), nullptr);
}

double roundedToDigits(double value, int digits) {
  const double step = std::pow(10, std::floor(std::log10(std::abs(value))) - digits + 1);
  return roundedTo(value, decimalsFor(step));
}

std::string inDecimals(double value, int decimals) {
  // Numbers so large have no decimals that would help.
  if (decimals > kMostDecimals || std::abs(value) > 1e15) return fmt::format("{}", value);
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

}  // namespace morphgrid
