#pragma once
#include <CLI/CLI.hpp>

namespace morphgrid {

/// `bench print`: how long designed grids take to become G-code.
void addPrintBenchmark(CLI::App& app);

}  // namespace morphgrid
