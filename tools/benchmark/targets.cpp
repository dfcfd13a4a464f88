#include "benchmark/targets.h"

#include <map>

namespace morphgrid {

SolveTarget targetOf(const std::string& problem) {
  static const std::map<std::string, SolveTarget> kTargets{
      {"egg_chair", {.seconds = Bounds{0.4, 0.15}}},
      {"iris_petal", {.seconds = Bounds{0.6, 0.25}, .shareOfReference = Bounds{1, 1}}},
      {"cup 35", {.cycles = Bounds{45, 25}}},
      {"cup 100", {.shareOfReference = Bounds{1. / 10, 1. / 40}, .cycles = Bounds{45, 25}}},
      {"cup 200", {.shareOfReference = Bounds{1. / 30, 1. / 100}, .cycles = Bounds{45, 25}}},
      {"cup 630", {.seconds = Bounds{60, 25}, .cycles = Bounds{70, 25}}}};
  const auto found = kTargets.find(problem);
  return found == kTargets.end() ? SolveTarget{} : found->second;
}

}  // namespace morphgrid
