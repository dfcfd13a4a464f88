#include "gpu/submission_pace.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace morphgrid {
namespace {

constexpr std::chrono::milliseconds kFramePatience(100);
// About what a workgroup of the dearest kernels takes.
constexpr double kUnknownGroupSeconds = 1.5e-5;
constexpr double kCompileSeconds = 0.03;
constexpr double kLeastGroupSeconds = 1e-8;
constexpr double kMostGroupSeconds = 1e-2;
constexpr long kGroupsOfCall = 4;  // What a call costs besides.
// In powers of actual over expected seconds: too long is worse than too short.
constexpr double kGainWhenSlow = 0.7;
constexpr double kGainWhenQuick = 0.3;
constexpr double kLargestSurprise = 10;

}  // namespace

double SubmissionPace::costOf(const CallWork& call) const {
  const auto known = groupSeconds_.find(call.kernel);
  const auto groups = static_cast<double>(call.groups + kGroupsOfCall);
  return known == groupSeconds_.end() ? kCompileSeconds + kUnknownGroupSeconds * groups
                                      : known->second * groups;
}

double SubmissionPace::sumCosts(const std::vector<CallWork>& work) const {
  double seconds = 0;
  for (const CallWork& call : work) {
    seconds += costOf(call);
  }
  return seconds;
}

double SubmissionPace::expect(const std::vector<CallWork>& work) const {
  const std::lock_guard lock(mutex_);
  return sumCosts(work);
}

bool SubmissionPace::knows(const char* kernel) const {
  const std::lock_guard lock(mutex_);
  return groupSeconds_.count(kernel) > 0;
}

void SubmissionPace::beginFrame() {
  const std::lock_guard lock(mutex_);
  frameEvents_ += 1 + frameEvents_ % 2;
}

void SubmissionPace::endFrame() {
  {
    const std::lock_guard lock(mutex_);
    frameEvents_ += frameEvents_ % 2;
  }
  frameEnded_.notify_all();
}

void SubmissionPace::giveWay() const {
  std::unique_lock lock(mutex_);
  frameEnded_.wait_for(lock, kFramePatience, [&] { return frameEvents_ % 2 == 0; });
}

long SubmissionPace::frameEvents() const {
  const std::lock_guard lock(mutex_);
  return frameEvents_;
}

/// Whether one was new.
bool SubmissionPace::meet(const std::vector<CallWork>& work) {
  const std::size_t before = groupSeconds_.size();
  for (const CallWork& call : work) {
    groupSeconds_.try_emplace(call.kernel, kUnknownGroupSeconds);
  }
  return groupSeconds_.size() > before;
}

void SubmissionPace::learn(const std::vector<CallWork>& work, double seconds,
                           long frameEventsBefore) {
  const std::lock_guard lock(mutex_);
  if (meet(work) || frameEventsBefore % 2 == 1 || frameEvents_ != frameEventsBefore) {
    return;
  }
  const double expected = sumCosts(work);
  const double surprise = std::clamp(seconds / expected, 1 / kLargestSurprise, kLargestSurprise);
  const double gain = surprise > 1 ? kGainWhenSlow : kGainWhenQuick;
  for (const CallWork& call : work) {
    // Each kernel in proportion to its share.
    const double factor = std::pow(surprise, gain * std::min(1.0, costOf(call) / expected));
    double& known = groupSeconds_.at(call.kernel);
    known = std::clamp(known * factor, kLeastGroupSeconds, kMostGroupSeconds);
  }
}

}  // namespace morphgrid
