#include "print/tier_tag.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>

namespace morphgrid {
namespace {

using Eigen::Vector2d;
using Strokes = std::vector<std::vector<Vector2d>>;

constexpr double kLargestDigit = 2.5;  // Width of a digit, mm; it is twice as high.
constexpr double kLeastDigit = 1.0;
constexpr double kDigitStep = 1.6;   // From digit to digit, in widths.
constexpr double kUnderline = -0.6;  // Where the line below them is, in widths.
constexpr double kLead = 0.6;        // By how much it begins before them.

/// Of seven segments, as strokes in a box of 1 x 2, from its lower left.
const std::vector<std::vector<Vector2d>>& digitStrokes(char digit) {
  static const std::array<Strokes, 10> kDigits{
      Strokes{{{0, 0}, {1, 0}, {1, 2}, {0, 2}, {0, 0}}},
      Strokes{{{1, 0}, {1, 2}}},
      Strokes{{{1, 0}, {0, 0}, {0, 1}, {1, 1}, {1, 2}, {0, 2}}},
      Strokes{{{0, 0}, {1, 0}, {1, 2}, {0, 2}}, {{0, 1}, {1, 1}}},
      Strokes{{{1, 0}, {1, 2}}, {{1, 1}, {0, 1}, {0, 2}}},
      Strokes{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 2}, {1, 2}}},
      Strokes{{{0, 1}, {1, 1}, {1, 0}, {0, 0}, {0, 2}, {1, 2}}},
      Strokes{{{1, 0}, {1, 2}, {0, 2}}},
      Strokes{{{0, 1}, {0, 0}, {1, 0}, {1, 2}, {0, 2}, {0, 1}, {1, 1}}},
      Strokes{{{0, 0}, {1, 0}, {1, 2}, {0, 2}, {0, 1}, {1, 1}}}};
  return kDigits[digit - '0'];
}

double distanceToSegment(const Vector2d& point, const Vector2d& from, const Vector2d& to) {
  const Vector2d along = to - from;
  const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (from + share * along - point).norm();
}

/// The first cell, its corners in a ring, the first of them at 0, 0.
using CellCorners = std::array<Vector2d, 4>;

double widthOf(const std::string& text) {
  return kDigitStep * (static_cast<double>(text.size()) - 1) + 1;
}

/// The text in the middle of the cell, along the diagonal from 0, 0.
Strokes textIn(const CellCorners& cell, const std::string& text, double size) {
  const Vector2d along = (cell[2] - cell[0]).normalized();
  const Vector2d middle = (cell[0] + cell[1] + cell[2] + cell[3]) / 4;
  return numberStrokes(text, middle, along, size);
}

double distanceToSides(const Strokes& strokes, const CellCorners& cell) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& stroke : strokes) {
    for (const Vector2d& point : stroke) {
      for (std::size_t side = 0; side < 4; ++side) {
        least = std::min(least, distanceToSegment(point, cell[side], cell[(side + 1) % 4]));
      }
    }
  }
  return least;
}

}  // namespace

std::vector<std::vector<Vector2d>> numberStrokes(const std::string& digits, const Vector2d& middle,
                                                 const Vector2d& along, double size) {
  const Vector2d up(-along.y(), along.x());
  const double width = widthOf(digits);
  const auto at = [&](double x, double y) -> Vector2d {
    return middle + size * ((x + (kLead - width) / 2) * along + (y - 1 - kUnderline / 2) * up);
  };
  const Vector2d begin = middle - size * (kLead + width) / 2 * along;
  Strokes strokes{{begin, at(-kLead, kUnderline), at(width, kUnderline)}};
  for (std::size_t n = 0; n < digits.size(); ++n) {
    const double left = kDigitStep * static_cast<double>(n);
    strokes.push_back({at(left + 1, kUnderline), at(left + 1, 0)});
    for (const auto& stroke : digitStrokes(digits[n])) {
      strokes.emplace_back();
      for (const Vector2d& point : stroke) {
        strokes.back().push_back(at(left + point.x(), point.y()));
      }
    }
  }
  return strokes;
}

std::vector<std::vector<Vector2d>> tagOf(const PrintPlan& plan, int tier) {
  const CellCorners cell{plan.at({0, 0, tier}), plan.at({1, 0, tier}), plan.at({1, 1, tier}),
                         plan.at({0, 1, tier})};
  const double needed = kTagGap + (plan.strutWidth() + plan.printer.lineWidth) / 2;
  for (double size = kLargestDigit; size >= kLeastDigit; size -= 0.25) {
    Strokes strokes = textIn(cell, fmt::format("{}", tier + 1), size);
    if (distanceToSides(strokes, cell) < needed) continue;
    const Vector2d begin = strokes.front().front();
    const Vector2d fromHub = (begin - cell[0]).normalized();
    strokes.insert(strokes.begin(), {cell[0] + plan.hub.diameter / 2 * fromHub, begin});
    return strokes;
  }
  return {};
}

}  // namespace morphgrid
