#pragma once
#include <CLI/CLI.hpp>

namespace morphgrid {

/// `inputs`: designs meshes with nothing else said, and writes docs/inputs.md.
void addInputsTable(CLI::App& app);

}  // namespace morphgrid
