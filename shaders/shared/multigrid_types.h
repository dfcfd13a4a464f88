// Compiles as GLSL and as C++: what the host and the kernels of the coarse levels of multigrid
// agree on. An unknown of a coarse level is a point's rigid motion (t, w): u(x) = t + w x (x -
// centre). Level 1 has one point per column of vertices.
#ifndef MORPHGRID_MULTIGRID_TYPES_H
#define MORPHGRID_MULTIGRID_TYPES_H
#include "shared/hessian_types.h"
#ifdef __cplusplus
namespace morphgrid {
#define CONSTANT constexpr
#else
#define CONSTANT const
#endif

// A level's matrix is a stencil of 9 blocks of 6 x 6. These are stored, the others are transposes.
CONSTANT uint kStencilSelf = 0u;
CONSTANT uint kStencilEast = 1u;
CONSTANT uint kStencilNorth = 2u;
CONSTANT uint kStencilNorthEast = 3u;
CONSTANT uint kStencilNorthWest = 4u;
CONSTANT uint kStencilSize = 5u;

// A block is 9 texels in 3 buffers: texel n of them is texel 3 p + n % 3 of buffer n / 3, p the
// point: with the block's quarters of 3 x 3, column n % 3 of (tt, tw, wt)[n / 3] in xyz, and
// ww[n / 3][n % 3] in w. Point by point, as 45 streams are more than a processor fetches ahead.
CONSTANT uint kBlockParts = 3u;
CONSTANT uint kPartTexels = 3u;

// Bindings beside those of solver_types.h.
CONSTANT uint kBindingMatrix = 16u;        // 15 texels, of 5 blocks a point
CONSTANT uint kBindingCoarseMatrix = 32u;  // 15 buffers
CONSTANT uint kBindingInverse = 48u;       // 3, texels or buffers: D^-1, a block a point
CONSTANT uint kBindingIterate = 52u;       // texels, a motion: vec4 t, vec4 w
CONSTANT uint kBindingFineVector = 55u;    // texels, of the finer level: a motion, or vec4 a vertex
CONSTANT uint kBindingFineResult = 56u;    // buffer
CONSTANT uint kBindingCoarseVector = 57u;  // texels, a motion
CONSTANT uint kBindingCentres = 58u;       // texels, ivec4 a point: centres as positions
CONSTANT uint kBindingCoarseCentres = 59u;    // texels or buffer
CONSTANT uint kBindingLevers = 60u;           // texels or buffer, ivec4 a point: see levers.comp
CONSTANT uint kBindingCoarsestInverse = 61u;  // texels, see coarsest_solve.comp

struct SmoothingPush {
  ivec2 size;    // Points, see topology.h; so below.
  float weight;  // omega
  int firstRow;  // First row of the points dispatched, see point_rows.glsl; so below.
};

struct TransferPush {
  ivec2 fineSize;
  ivec2 coarseSize;
  float resolution;  // Spacings per step of the fixed-point positions.
  int firstRow;
};

struct ColumnPush {
  GridPush grid;
  int centreLayer;  // Whose vertices are the columns' centres.
  float damping;    // Weight of every edge in a Laplacian that is added to the Hessian.
  int firstRow;
};

struct CoarsestPush {
  int halfMotions;  // Twice the number of points.
};

#ifdef __cplusplus
static_assert(sizeof(SmoothingPush) == 16);
static_assert(sizeof(TransferPush) == 24);
static_assert(offsetof(ColumnPush, firstRow) == sizeof(GridPush) + 8);
static_assert(sizeof(CoarsestPush) == 4);
}  // namespace morphgrid
#endif
#undef CONSTANT
#endif
