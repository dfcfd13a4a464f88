// Compiles as GLSL and as C++: what the host and the vector kernels of L-BFGS agree on.
#ifndef MORPHGRID_LBFGS_TYPES_H
#define MORPHGRID_LBFGS_TYPES_H
#include "shared/solver_types.h"
#ifdef __cplusplus
namespace morphgrid {
#define CONSTANT constexpr
#else
#define CONSTANT const
#endif

// Pairs of steps s and changes y of the gradient that L-BFGS remembers; more do not help with a
// preconditioner that is as good as a V-cycle.
CONSTANT uint kPairs = 3u;

// Bindings of the vector kernels. Vectors hold a vec4 a vertex: xyz, 0.
CONSTANT uint kBindingSteps = 0u;       // 3 texels: s
CONSTANT uint kBindingChanges = 3u;     // 3 texels: y
CONSTANT uint kBindingBase = 6u;        // texels: what is added to
CONSTANT uint kBindingGradient = 7u;    // texels
CONSTANT uint kBindingCorrection = 8u;  // texels: the V-cycle's result
CONSTANT uint kBindingOutput = 9u;      // buffer
CONSTANT uint kBindingOutput2 = 10u;    // buffer
CONSTANT uint kBindingFrom = 11u;       // texels, ivec4 a vertex: positions
CONSTANT uint kBindingTo = 12u;         // texels, ivec4 a vertex: positions
CONSTANT uint kBindingReduced = 13u;    // buffer, per workgroup

CONSTANT uint kVectorInvocations = 128u;
// A reduction's workgroups, each of which leaves one value for the host to add up.
CONSTANT uint kMostReductionGroups = 256u;

// A turn of a joint by a radian counts as so large a move, in spacings, where steps are bounded.
CONSTANT float kMovePerTurn = 4.0f;

struct CombinePush {
  uint count;  // Texels.
  uint stride;
  uint vertices;  // Texels behind these are turns of joints (frame_types.h); so below.
  float weights[kPairs];
};

struct DotsPush {
  uint count;
  uint stride;
};

struct StepPush {
  uint count;
  float share;       // Share of the direction that is gone, downhill.
  float resolution;  // Spacings per step of the fixed-point positions.
  uint vertices;
};

// Dot products of what L-BFGS keeps.
struct PairDots {
  vec4 gradient;         // s_i . g, and in w z . g
  vec4 correction;       // y_i . z
  vec4 changes[kPairs];  // [i]: s_i . y_j
};

#ifdef __cplusplus
static_assert(sizeof(CombinePush) == 24);
static_assert(sizeof(DotsPush) == 8);
static_assert(sizeof(StepPush) == 16);
static_assert(sizeof(PairDots) == 80);
}  // namespace morphgrid
#endif
#undef CONSTANT
#endif
