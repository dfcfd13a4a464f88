// Compiles as GLSL and as C++: what the host and the solver's kernels agree on.
#ifndef MORPHGRID_SOLVER_TYPES_H
#define MORPHGRID_SOLVER_TYPES_H
#ifdef __cplusplus
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
namespace morphgrid {
using glm::ivec2;
using glm::ivec3;
using glm::ivec4;
using glm::uvec4;
using glm::vec4;
using uint = std::uint32_t;
#define CONSTANT constexpr
#define ALIGN_AS_GLSL alignas(16)
#else
#define CONSTANT const
#define ALIGN_AS_GLSL
#endif

// Positions are fixed-point integers, ivec4 a vertex: x, y, z, and in w ten more bits of each.
CONSTANT uint kExtraBits = 10u;

// One invocation of the sweep moves a block of columns, with all their layers: neighbours share
// loads and corners. Doubles get smaller blocks, which compile faster.
CONSTANT uint kSweepBlockU = 2u;
CONSTANT uint kSweepBlockV = 2u;
CONSTANT uint kPreciseSweepBlockV = 1u;
// A workgroup of the sweep is a subgroup: short ones leave few invocations idle at the end of a
// row.
CONSTANT uint kLargestSubgroup = 128u;  // of any device
// Up to here the layers are unrolled: on lavapipe the sweep is 1.7 times faster for it, but
// compiling takes 0.2 s a layer.
CONSTANT uint kUnrolledLayers = 4u;
CONSTANT uint kControlInvocations = 128u;

// Every kSweepsPerCheck-th sweep measures energy and residual; even, so that the measured state
// always lies in the same of the two position buffers.
CONSTANT uint kSweepsPerCheck = 16u;

// Bindings of the solver's kernels.
CONSTANT uint kBindingPositions = 0u;      // texels, ivec4 a vertex
CONSTANT uint kBindingNextPositions = 1u;  // buffer, ivec4 a vertex; holds the previous ones before
CONSTANT uint kBindingPreviousPositions = 7u;  // the same buffer as texels
CONSTANT uint kBindingRest = 2u;               // texels, ivec4 a vertex: rest lengths and step
CONSTANT uint kBindingStiffness = 3u;          // texels, vec4 a vertex: w c of +u, +v, +w
CONSTANT uint kBindingPrinted = 62u;           // texels, vec4 a vertex, see below
CONSTANT uint kBindingState = 4u;              // buffer, SolverState
CONSTANT uint kBindingPartials = 5u;  // buffer, vec4 a workgroup: energy, |g|^2, g.velocity
CONSTANT uint kBindingSamples = 6u;   // buffer, SolverSample

// Specialisation constants of the kernels that walk columns. The first is that of every kernel
// whose workgroup is a subgroup.
CONSTANT uint kConstantSubgroupSize = 0u;
CONSTANT uint kConstantLayers = 1u;            // 0: known at run time only; works for any number.
CONSTANT uint kConstantUniformStiffness = 2u;  // bool
CONSTANT uint kConstantMeasures = 3u;          // bool, of the sweep
CONSTANT uint kConstantPrintedCorners = 4u;    // bool: corners in a layer rest as printed
CONSTANT uint kColumnConstants = 5u;           // how many there are

// Rest lengths are an ivec4 a vertex: L of its struts to +u, +v and +w in fixed point, and in w the
// bits of a float: how far the vertex steps per unit of force.

// Where struts were printed at an angle that they keep, the texel of a vertex holds the cosine and
// the sine of the printed directions of its struts to +u (xy) and to +v (zw) in the sheet's plane.

// What every walk through the columns (columns.glsl) needs. Lengths are in units of the spacing,
// energies in stiffness x spacing^2. GLSL rounds its size up to the ivec3's alignment, 16 bytes:
// what follows it lies behind that.
struct ALIGN_AS_GLSL GridPush {
  ivec3 size;              // Vertices of the grid, see topology.h.
  float resolution;        // Spacings per step of the fixed-point positions, a power of two.
  float restResolution;    // Spacings per step of the fixed-point rest lengths, a power of two.
  float angleWeight;       // Of corners in a layer.
  float postAngleWeight;   // Of corners between a layer and its posts.
  float lateralStiffness;  // Used where stiffness is uniform: kUniformStiffness of columns.glsl.
  float verticalStiffness;
};

struct SweepPush {
  GridPush grid;
  uint sweep;  // Number of this sweep since the last check, 0 .. kSweepsPerCheck-1.
};

struct ControlPush {
  uint partialCount;
  uint sampleCapacity;
  float residualScale;  // residual = |g| residualScale
};

struct SolverState {
  uint sweepsSinceRestart;  // Sweeps since the Chebyshev acceleration last restarted.
  uint sampleCount;
  uint done;  // 1 once the residual is below the tolerance: sweeps then change nothing.
  float tolerance;
};

struct SolverSample {
  float energy;
  float residual;
};

#ifdef __cplusplus
static_assert(sizeof(GridPush) % 16 == 0);
static_assert(offsetof(SweepPush, sweep) == sizeof(GridPush));
static_assert(sizeof(ControlPush) == 12);
static_assert(sizeof(SolverState) == 16);
static_assert(sizeof(SolverSample) == 8);
}  // namespace morphgrid
#endif
#undef CONSTANT
#undef ALIGN_AS_GLSL
#endif
