#pragma once
#include <nlohmann/json.hpp>

#include "grid/strut_grid.h"
#include "solve/device_grid.h"

namespace morphgrid {

/// Nanoseconds per vertex of the finest level's kernels, medians of `rounds`, by name:
/// {"gradient": {"wall_ns_per_vertex": ..., "cpu_ns_per_vertex": ...}, ...}
nlohmann::json measureKernels(const Device& device, const StrutGrid& grid, int rounds);

/// As a table.
void printKernels(const nlohmann::json& kernels);

}  // namespace morphgrid
