#pragma once
#include <CLI/CLI.hpp>

namespace morphgrid {

/// The command `frame`: times whole solves of cups as frames, beside the same cups of springs.
void addFrameBenchmark(CLI::App& app);

}  // namespace morphgrid
