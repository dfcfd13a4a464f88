#pragma once
#include <vector>

namespace morphgrid {

/// Wall time, and what all threads of this process together spent: the second hardly depends on
/// what else runs on the machine.
struct Cost {
  double wall;  ///< seconds
  double cpu;
};

/// Since some time in the past.
Cost costSoFar();

/// values: not empty.
double median(std::vector<double> values);

template <typename Work>
Cost costOf(Work work) {
  const Cost before = costSoFar();
  work();
  const Cost after = costSoFar();
  return {after.wall - before.wall, after.cpu - before.cpu};
}

}  // namespace morphgrid
