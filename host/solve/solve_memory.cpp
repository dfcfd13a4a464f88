#include "solve/solve_memory.h"

#include <algorithm>

#include "shared/multigrid_types.h"
#include "shared/solver_types.h"
#include "solve/coarse_levels.h"
#include "solve/point_kernel.h"

namespace morphgrid {
namespace {

constexpr std::uint64_t kTexel = sizeof(vec4);

// Texels a vertex.
constexpr std::uint64_t kGridTexels = 4;                     // DeviceGrid
constexpr std::uint64_t kStagingTexels = 1;                  // A download on its way to the host.
constexpr std::uint64_t kCycleTexels = 5;                    // VCycle, GridHessian
constexpr std::uint64_t kCycleEndTexels = 2;                 // What it takes and gives.
constexpr std::uint64_t kDescentTexels = 11 + kCycleTexels;  // LbfgsVectors, with those.
constexpr std::uint64_t kVertexTexels = kGridTexels + kStagingTexels + kDescentTexels;
constexpr std::uint64_t kPrintedTexels = 1;  // Directions.
// Of a frame: two of positions, vectors and the Hessian's positions, printed directions, what acts
// on joints and where they were printed, and blocks of 6 x 6 for the two texels of 3 x 3.
constexpr std::uint64_t kFrameTexels = 2 * (kVertexTexels - 2 - 2) + 2 + kPrintedTexels + 2 + 9;
constexpr std::uint64_t kAdjointTexels = 2;  // AdjointSolver, beside the descent's.

// Texels a point of a coarse level: the matrix and its inverse diagonal, centre, three motions and
// levers.
constexpr std::uint64_t kBlockTexels = std::uint64_t{kBlockParts} * kPartTexels;
constexpr std::uint64_t kPointTexels = (kStencilSize + 1) * kBlockTexels + 1 + 6 + 1;

// Grids, energy and checkpoint, as measured. Files to export take more, after the solve.
constexpr std::uint64_t kHostBytesPerVertex = 1000;
// Two lateral struts a vertex: ten pairs of L-BFGS, again in a checkpoint and in the bytes of one
// that is read.
constexpr std::uint64_t kInverseHostBytesPerVertex = 1800;

std::uint64_t texelsOf(Mechanics mechanics) {
  if (mechanics == Mechanics::frame) return kFrameTexels;
  const bool isPrinted = mechanics == Mechanics::springsAsPrinted;
  return kVertexTexels + (isPrinted ? kPrintedTexels : 0);
}

std::uint64_t vertices(const GridShape& shape) {
  return std::uint64_t(shape.verticesU) * shape.verticesV * shape.layers;
}

/// Points of all coarse levels: each has a quarter of those of the one above.
std::uint64_t points(const GridShape& shape) {
  return std::uint64_t(shape.verticesU) * shape.verticesV * 4 / 3;
}

/// The coarsest matrix's inverse, and its copy on the way to the device.
std::uint64_t inverseTexels(const GridShape& shape) {
  const auto halfMotions = static_cast<std::uint64_t>(2 * coarsestPoints(shape).count());
  return 2 * 3 * halfMotions * halfMotions;
}

/// With so many texels a vertex, and coarse levels.
SolveMemory memoryWithLevels(const GridShape& shape, std::uint64_t vertexTexels) {
  const std::uint64_t texels =
      vertexTexels * vertices(shape) + kPointTexels * points(shape) + inverseTexels(shape);
  const auto partTexels = [&](int rows) {
    return kPartTexels * static_cast<std::uint64_t>(shape.verticesU) *
           static_cast<std::uint64_t>(rows);
  };
  return {kTexel * texels, kHostBytesPerVertex * vertices(shape),
          kTexel * std::max(vertices(shape), partTexels(shape.verticesV)),
          kTexel * std::max(vertices(shape), partTexels(std::min(shape.verticesV, kChunkRows)))};
}

}  // namespace

SolveMemory multigridMemory(const GridShape& shape, Mechanics mechanics) {
  return memoryWithLevels(shape, texelsOf(mechanics));
}

SolveMemory inverseDesignMemory(const GridShape& shape, Mechanics mechanics) {
  SolveMemory memory = multigridMemory(shape, mechanics);
  memory.device +=
      kTexel * kAdjointTexels * (mechanics == Mechanics::frame ? 2 : 1) * vertices(shape);
  memory.host += kInverseHostBytesPerVertex * vertices(shape);
  return memory;
}

SolveMemory jacobiMemory(const GridShape& shape) {
  return memoryWithLevels(shape, kGridTexels + kStagingTexels + kCycleTexels + kCycleEndTexels);
}

}  // namespace morphgrid
