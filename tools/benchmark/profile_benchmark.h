#pragma once
#include <CLI/CLI.hpp>

namespace morphgrid {

/// The command `profile`: where the time of a solve by multigrid goes.
void addProfileBenchmark(CLI::App& app);

}  // namespace morphgrid
