#pragma once
#include <CLI/CLI.hpp>

namespace morphgrid {

/// The command `robust`: solves grids of all sorts by multigrid and tells how each one ended.
void addRobustnessTable(CLI::App& app);

}  // namespace morphgrid
