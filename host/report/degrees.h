#pragma once
#include <numbers>

namespace morphgrid {

constexpr double degrees(double angle) { return angle * 180 / std::numbers::pi; }
constexpr double radians(double angle) { return angle * std::numbers::pi / 180; }

}  // namespace morphgrid
