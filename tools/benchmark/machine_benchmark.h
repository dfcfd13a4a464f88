#pragma once
#include <CLI/CLI.hpp>

namespace morphgrid {

/// The command `machine`: how many bytes a device moves and how much it computes in a second.
void addMachineBenchmark(CLI::App& app);

}  // namespace morphgrid
