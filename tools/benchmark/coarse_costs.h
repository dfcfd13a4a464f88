#pragma once
#include <nlohmann/json.hpp>

#include "gpu/device.h"
#include "grid/strut_grid.h"

namespace morphgrid {

/// Nanoseconds per vertex of a build and of a cycle of multigrid's coarse levels, medians of
/// `rounds`: {"coarse_build": {"wall_ns_per_vertex": ..., "cpu_ns_per_vertex": ...},
/// "coarse_cycle": ...}
nlohmann::json measureCoarseLevels(const Device& device, const StrutGrid& grid, int rounds);

}  // namespace morphgrid
