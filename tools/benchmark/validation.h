#pragma once
#include <CLI/CLI.hpp>

namespace morphgrid {

/// The command `validate`: writes the tables of docs/validation.md.
void addValidation(CLI::App& app);

}  // namespace morphgrid
