#pragma once
#include <CLI/CLI.hpp>

namespace morphgrid {

/// The command `solve`: times whole solves, multigrid beside its peers.
void addSolveBenchmark(CLI::App& app);

}  // namespace morphgrid
