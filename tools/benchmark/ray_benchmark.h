#pragma once
#include <CLI/CLI.hpp>

namespace morphgrid {

/// The command `rays`: times building the hierarchy of a bumpy sphere and casting rays at it.
void addRayBenchmark(CLI::App& app);

}  // namespace morphgrid
