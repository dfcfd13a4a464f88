#pragma once
#include <cstdint>
#include <limits>
#include <string>

namespace morphgrid {

/// The finite numbers between two bounds, each of which may belong to the range.
struct NumberRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool lowIncluded = false;
  bool highIncluded = false;

  /// False for nan and infinities.
  bool contains(double number) const;
};

constexpr NumberRange above(double low) { return {.low = low}; }
constexpr NumberRange atLeast(double low) { return {.low = low, .lowIncluded = true}; }
constexpr NumberRange between(double low, double high) { return {.low = low, .high = high}; }
constexpr NumberRange aboveUpTo(double low, double high) { return {low, high, false, true}; }
constexpr NumberRange fromTo(double low, double high) { return {low, high, true, true}; }

// The device computes in single precision. Within these bounds squares and ratios of what a scene
// gives stay numbers there.
constexpr double kLargestLength = 1e15;
constexpr NumberRange kCoordinates = fromTo(-kLargestLength, kLargestLength);
constexpr NumberRange kLengths = fromTo(1e-30, kLargestLength);
constexpr NumberRange kWidths = fromTo(0, kLargestLength);
constexpr NumberRange kWeights = fromTo(1e-9, 1e9);

/// The integers from low to high, both included.
struct IntegerRange {
  std::int64_t low = std::numeric_limits<std::int64_t>::min();
  std::int64_t high = std::numeric_limits<std::int64_t>::max();

  bool contains(std::int64_t number) const { return low <= number && number <= high; }
};

/// "a number > 0 and <= 1", "a finite number".
std::string describe(const NumberRange& range);
/// "an integer >= 1"; bounds at the limits of int64 go without saying.
std::string describe(const IntegerRange& range);

}  // namespace morphgrid
