#pragma once
#include <cstdint>

#include "grid/strut_grid.h"

namespace morphgrid {

/// What solving a grid on the device takes; bytes, about.
struct SolveMemory {
  std::uint64_t device;
  std::uint64_t host;
  std::uint64_t largestBuffer;  ///< The largest buffer on the device.
  /// The most that kernels bind of a buffer that they write: a chunk of it.
  std::uint64_t mostBound;
};

/// MultigridSolver, with checkpoints.
SolveMemory multigridMemory(const GridShape& shape, Mechanics mechanics = Mechanics::springs);

/// MultigridSolver with adjoints, and what inverse design keeps on the host, with checkpoints.
SolveMemory inverseDesignMemory(const GridShape& shape, Mechanics mechanics = Mechanics::springs);

/// A stage of JacobiSolver, with checkpoints and the V-cycle by which its end is judged.
SolveMemory jacobiMemory(const GridShape& shape);

}  // namespace morphgrid
