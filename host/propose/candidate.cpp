#include "propose/candidate.h"

#include <fmt/format.h>

#include <limits>
#include <numbers>

namespace morphgrid {
namespace {

// Of the struts: inverse design finds other lengths for them.
constexpr double kFewOutOfRange = 0.03;
constexpr double kMostTwist = 6;  // Degrees, in the mean.
// What a radian of twist counts, in shares of struts out of range.
constexpr double kTwistWeight = 0.1;

double inDegrees(double angle) { return angle * 180 / std::numbers::pi; }

double shareOutOfRange(const SheetFigures& sheet) {
  return static_cast<double>(sheet.strutsOutOfRange) / sheet.lateralStruts;
}

bool isSprings(const DesignTrial& trial) { return trial.sheet.lateralStruts == 0; }

}  // namespace

std::string describe(const Candidate& candidate) {
  return fmt::format("{}, slopes up to {:g}, {} net, {:.0f} % of the surface",
                     candidate.rating.sight.name, candidate.slope, nameOf(candidate.design.net),
                     100 * candidate.share);
}

bool isGood(const DesignTrial& trial) {
  return trial.failure.empty() &&
         (isSprings(trial) || (shareOutOfRange(trial.sheet) <= kFewOutOfRange &&
                               inDegrees(trial.sheet.meanTwist) <= kMostTwist));
}

double badness(const DesignTrial& trial) {
  if (!trial.failure.empty()) return std::numeric_limits<double>::infinity();
  if (isSprings(trial)) return trial.net.meanAngleDeviation;  // What springs resist.
  return shareOutOfRange(trial.sheet) + kTwistWeight * trial.sheet.meanTwist;
}

std::string describe(const DesignTrial& trial) {
  if (!trial.failure.empty()) return trial.failure;
  if (isSprings(trial)) {
    return fmt::format("corners {:.1f} degrees off 90 in the mean",
                       inDegrees(trial.net.meanAngleDeviation));
  }
  return fmt::format("{:.1f} % of the struts beyond the material's range, twist {:.1f} degrees",
                     100 * shareOutOfRange(trial.sheet), inDegrees(trial.sheet.meanTwist));
}

}  // namespace morphgrid
