#pragma once
#include <numbers>

namespace morphgrid {

constexpr double degrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace morphgrid
