#include "gpu/submission_pace.h"

#include <algorithm>
#include <cmath>

namespace morphgrid {
namespace {

constexpr double kUnknownGroupSeconds = 1.5e-5;  // Of the dearest kernels, about.
constexpr double kLeastGroupSeconds = 1e-8;
constexpr double kMostGroupSeconds = 1e-2;
constexpr long kGroupsOfCall = 4;  // What a call costs besides.
// In powers of actual over expected seconds: too long is worse than too short.
constexpr double kGainWhenSlow = 0.7;
constexpr double kGainWhenQuick = 0.3;
constexpr double kLargestSurprise = 10;  // First runs compile.

}  // namespace

double SubmissionPace::costOf(const CallWork& call) const {
  const auto known = groupSeconds_.find(call.kernel);
  const double groupSeconds = known == groupSeconds_.end() ? kUnknownGroupSeconds : known->second;
  return groupSeconds * static_cast<double>(call.groups + kGroupsOfCall);
}

double SubmissionPace::expect(const std::vector<CallWork>& work) const {
  const std::lock_guard lock(mutex_);
  double seconds = 0;
  for (const CallWork& call : work) {
    seconds += costOf(call);
  }
  return seconds;
}

void SubmissionPace::learn(const std::vector<CallWork>& work, double seconds,
                           long frameEventsBefore) {
  if (frameEventsBefore % 2 == 1 || frameEvents_ != frameEventsBefore) {
    return;
  }
  const double expected = expect(work);
  const double surprise = std::clamp(seconds / expected, 1 / kLargestSurprise, kLargestSurprise);
  const double gain = surprise > 1 ? kGainWhenSlow : kGainWhenQuick;
  const std::lock_guard lock(mutex_);
  for (const CallWork& call : work) {
    // Each kernel in proportion to its share.
    const double factor = std::pow(surprise, gain * std::min(1.0, costOf(call) / expected));
    double& known = groupSeconds_.try_emplace(call.kernel, kUnknownGroupSeconds).first->second;
    known = std::clamp(known * factor, kLeastGroupSeconds, kMostGroupSeconds);
  }
}

}  // namespace morphgrid
