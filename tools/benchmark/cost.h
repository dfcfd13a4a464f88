#pragma once
#include <time.h>

#include <algorithm>
#include <chrono>
#include <vector>

namespace morphgrid {

/// Seconds of wall time, and what all threads of this process together spent: the second hardly
/// depends on what else runs on the machine.
struct Cost {
  double wall;
  double cpu;
};

inline double cpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

template <typename Work>
Cost costOf(Work work) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const double cpuStart = cpuSeconds();
  work();
  return {std::chrono::duration<double>(Clock::now() - start).count(), cpuSeconds() - cpuStart};
}

inline double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

}  // namespace morphgrid
