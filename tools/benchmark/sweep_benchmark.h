#pragma once
#include <CLI/CLI.hpp>

namespace morphgrid {

/// The command `sweep`: times one sweep of jacobi beside a hand-vectorised loop, and multigrid's
/// kernels.
void addSweepBenchmark(CLI::App& app);

}  // namespace morphgrid
