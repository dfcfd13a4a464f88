#pragma once
#include <string>
#include <vector>

#include "benchmark/fidelity_run.h"

namespace morphgrid {

/// Markdown, three rows a scene: the paper's design, the one for the shape in its model, and ours.
std::string sceneTable(const std::vector<FidelityTrio>& trios);

/// Markdown, a row per patch and one of medians. trios: at least one.
std::string randomTable(const std::vector<FidelityTrio>& trios);

/// One line for the terminal.
std::string describe(const FidelityRun& run);

}  // namespace morphgrid
