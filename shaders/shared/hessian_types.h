// Compiles as GLSL and as C++: what the host and the kernels of the finest level of multigrid agree
// on.
#ifndef MORPHGRID_HESSIAN_TYPES_H
#define MORPHGRID_HESSIAN_TYPES_H
#include "shared/solver_types.h"
#ifdef __cplusplus
namespace morphgrid {
#define CONSTANT constexpr
#else
#define CONSTANT const
#endif

// Bindings beside those of solver_types.h. Vectors hold a vec4 a vertex: xyz, 0.
CONSTANT uint kBindingVector = 8u;     // texels: what the Hessian is applied to
CONSTANT uint kBindingRightSide = 9u;  // texels
CONSTANT uint kBindingResult = 10u;    // buffer
CONSTANT uint kBindingInverseDiagonal =
    11u;  // texels or buffer, vec4: xx, yy, zz of a vertex's D^-1
CONSTANT uint kBindingInverseOffDiagonal = 12u;  // texels or buffer, vec4: yz, xz, xy
CONSTANT uint kBindingSums = 13u;  // buffer, one vec4: energy and |g|^2 as pairs of floats

// Rows of columns per invocation, kSweepBlockU in each: two would save a tenth of the time of a
// product, and take twice as long to compile.
CONSTANT uint kHessianBlockV = 1u;
CONSTANT uint kReductionInvocations = 128u;
// Invocations a workgroup in kernels that need no neighbours.
CONSTANT uint kVertexInvocations = 128u;

struct HessianPush {
  GridPush grid;
  float damping;  // Weight of every edge in a Laplacian that is added to the Hessian.
  float weight;   // omega, of a step of block-Jacobi smoothing.
};

struct ReductionPush {
  uint count;
};

#ifdef __cplusplus
static_assert(offsetof(HessianPush, weight) == sizeof(GridPush) + 4);
static_assert(sizeof(ReductionPush) == 4);
}  // namespace morphgrid
#endif
#undef CONSTANT
#endif
