// Compiles as GLSL and as C++: what the host and the vector kernels of conjugate gradients agree
// on.
#ifndef MORPHGRID_ADJOINT_TYPES_H
#define MORPHGRID_ADJOINT_TYPES_H
#include "shared/lbfgs_types.h"
#ifdef __cplusplus
namespace morphgrid {
using glm::vec2;
#define CONSTANT constexpr
#else
#define CONSTANT const
#endif

// Vectors hold a vec4 a vertex: xyz, 0.
CONSTANT uint kBindingFirst = 0u;      // texels
CONSTANT uint kBindingSecond = 1u;     // texels
CONSTANT uint kBindingSolution = 2u;   // buffer
CONSTANT uint kBindingRemainder = 3u;  // buffer: the residual
CONSTANT uint kBindingProducts = 4u;   // buffer, vec2 per workgroup
CONSTANT uint kBindingScalars = 5u;    // buffer, ConjugateScalars

// The scalars of conjugate gradients for A x = b, M about the inverse of A: residual r, direction
// p. All 0 before the first.
struct ConjugateScalars {
  float step;           // What the solution moves along p: r . M r / p . A p
  float turn;           // What of p goes into the next direction.
  float mixed;          // r . M r
  float squared;        // r . r
  float isNotPositive;  // 1 once a p . A p was not positive; steps are 0 then.
};

// After a product with A, or after r and M r have changed.
CONSTANT uint kScalarsOfProduct = 0u;
CONSTANT uint kScalarsOfRemainder = 1u;

struct AdvancePush {
  uint count;  // Vertices.
};

struct ScalarsPush {
  uint groups;  // Sums to add up.
  uint stage;   // kScalarsOf...
};

#ifdef __cplusplus
static_assert(sizeof(ConjugateScalars) == 20);
static_assert(sizeof(AdvancePush) == 4);
static_assert(sizeof(ScalarsPush) == 8);
}  // namespace morphgrid
#endif
#undef CONSTANT
#endif
