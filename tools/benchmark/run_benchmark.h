#pragma once
#include <CLI/CLI.hpp>

namespace morphgrid {

/// The command `run`: whole runs of the program, from the scene file to the files, beside another
/// build of it.
void addRunBenchmark(CLI::App& app);

}  // namespace morphgrid
