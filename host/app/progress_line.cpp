#include "app/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace morphgrid {
namespace {

constexpr double kSecondsBetweenRedraws = 0.1;
constexpr double kSecondsBetweenLines = 5;
constexpr int kBarWidth = 24;
constexpr int kFewestSamples = 8;  // That tell a rate.
// Times the seconds so far. What lies beyond is no estimate: the residual hardly falls just now.
constexpr double kFarthestView = 30;

std::string bar(double share) {
  const int filled = static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * kBarWidth));
  return std::string(filled, '#') + std::string(kBarWidth - filled, '.');
}

std::string timeLeft(double seconds) {
  if (seconds < 0) {
    return "time left unknown";
  }
  return seconds < 90 ? fmt::format("about {:.0f} s left", std::ceil(seconds))
                      : fmt::format("about {:.0f} min left", std::ceil(seconds / 60));
}

using Samples = std::vector<ConvergenceSample>::const_iterator;

/// Seconds from one sample to the next; there are at least two.
double medianPace(Samples first, Samples last) {
  std::vector<double> paces;
  for (auto next = first + 1; next != last; ++next) {
    paces.push_back(next->seconds - (next - 1)->seconds);
  }
  const auto middle = paces.begin() + static_cast<std::ptrdiff_t>(paces.size() / 2);
  std::nth_element(paces.begin(), middle, paces.end());
  return *middle;
}

}  // namespace

double estimateSecondsLeft(const std::vector<ConvergenceSample>& samples, double tolerance) {
  if (samples.empty()) {
    return -1;
  }
  const ConvergenceSample& now = samples.back();
  // Residuals of another grid say nothing of this one's.
  const auto others = std::find_if(samples.rbegin(), samples.rend(), [&](const auto& sample) {
    return sample.gridShare != now.gridShare;
  });
  const auto first = others.base();
  if (std::distance(first, samples.end()) < kFewestSamples) {
    return -1;
  }
  const auto half = samples.end() - 1 - std::distance(first, samples.end()) / 2;
  const double fall = std::log(half->residual / now.residual);
  if (!(fall > 0)) {
    return -1;
  }
  const auto steps = static_cast<double>(std::distance(half, samples.end()) - 1);
  const double left = std::max(0.0, std::log(now.residual / tolerance) / fall) * steps *
                      medianPace(half, samples.end());
  return left < kFarthestView * now.seconds ? left : -1;
}

ProgressLine::ProgressLine(std::string stage, double tolerance, StageOutlook outlook)
    : stage_(std::move(stage)),
      tolerance_(tolerance),
      outlook_(outlook),
      onTerminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (barDrawn_) {
    std::fputs("\r\033[K", stderr);
  }
}

void ProgressLine::update(const ConvergenceSample& sample) {
  samples_.push_back(sample);
  const double left =
      sample.secondsLeft >= 0 ? sample.secondsLeft : estimateSecondsLeft(samples_, tolerance_);
  tell(fmt::format("{} iterations, residual {:.1e}", sample.iteration, sample.residual),
       sample.seconds, left);
}

void ProgressLine::tell(const std::string& what, double seconds, double secondsLeft) {
  const double pause = onTerminal_ ? kSecondsBetweenRedraws : kSecondsBetweenLines;
  if (seconds - lastPrinted_ < pause) {
    return;
  }
  lastPrinted_ = seconds;
  if (secondsLeft >= 0) secondsLeft += outlook_.afterwards * (seconds + secondsLeft);
  const std::string status = fmt::format("{}: {}, {}", stage_, what, timeLeft(secondsLeft));
  if (onTerminal_) {
    const double soFar = outlook_.secondsBefore + seconds;
    const double done = secondsLeft >= 0 ? soFar / (soFar + secondsLeft) : 0;
    fmt::print(stderr, "\r\033[K[{}] {}", bar(done), status);
    std::fflush(stderr);
    barDrawn_ = true;
  } else {
    fmt::print(stderr, "{}\n", status);
  }
}

}  // namespace morphgrid
