#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace morphgrid {

/// What is asked: prints whose shrinks are off.
struct ToleranceRequest {
  double share = 0.1;  ///< One sigma of a shrink, or of a post's length, as a share of it; > 0.
  int samples = 40;    ///< Prints of each kind of error, >= 1.
  std::uint64_t seed = 1;
};

/// How a print came out whose shrinks were off: distances as LaidShape's.
struct DisturbedPrint {
  double rmsPercent = 0;
  double maxPercent = 0;
  bool isConverged = true;
  bool isJump = false;  ///< It came to rest in another equilibrium.
};

/// Prints with random errors of one kind.
struct DisturbedPrints {
  std::string what;  ///< Which struts are off together: "each strut".
  std::vector<DisturbedPrint> prints;
};

/// What becomes of prints of one kind.
struct DisturbedFigures {
  double meanRms = 0;
  double rms95 = 0;  ///< 95 of 100 prints are no farther away.
  double meanMax = 0;
  int jumps = 0;
  int unconverged = 0;
};
DisturbedFigures figuresOf(const std::vector<DisturbedPrint>& prints);

/// The quantile of at least one value, between values linearly. quantile: in [0, 1].
double quantileOf(std::vector<double> values, double quantile);

/// What happens when a strut's, or a tier's, shrinks are off by the share: percent of the diagonal.
struct ToleranceLever {
  std::string what;
  double movement;  ///< Of the middle layer, RMS, to first order, about.
  /// Change of the distance (RMS) when it shrinks that much more, to first order; nothing where the
  /// distance is about zero.
  std::optional<double> firstOrder;
  double more, less;  ///< The change when it shrinks that much more, and less, solved.
};

/// How far prints with errors are from the target, or from the design's end.
struct PrintTolerance {
  ToleranceRequest request;
  std::string model;  ///< What judged them, as material.model says it.
  bool hasTarget = false;
  DisturbedPrint undisturbed, shrinksLess, shrinksMore;  ///< All shrinks less, and more, by share.
  std::vector<DisturbedPrints> kinds;
  std::vector<ToleranceLever> struts, tiers;  ///< Those that matter most, first.
};

/// Rows of the table on the terminal.
std::string toleranceTable(const PrintTolerance& tolerance);

/// A section of assembly.html: the figures, and each print as a mark on a scale.
std::string tolerancePage(const PrintTolerance& tolerance);

/// What whoever prints should know of it.
std::vector<std::string> toleranceNotices(const PrintTolerance& tolerance);

}  // namespace morphgrid
