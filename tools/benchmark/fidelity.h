#pragma once
#include <CLI/CLI.hpp>

namespace morphgrid {

/// The command `fidelity`: sets the paper's design beside ours.
void addFidelityTable(CLI::App& app);

}  // namespace morphgrid
