#pragma once
#include <string>
#include <vector>

#include "benchmark/fidelity_run.h"

namespace morphgrid {

/// Markdown, two rows a scene: the paper's design and ours.
std::string sceneTable(const std::vector<FidelityPair>& pairs);

/// Markdown, a row per patch and one of medians. pairs: at least one.
std::string randomTable(const std::vector<FidelityPair>& pairs);

/// One line for the terminal.
std::string describe(const FidelityRun& run);

}  // namespace morphgrid
