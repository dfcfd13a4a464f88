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

struct AdvancePush {
  uint count;  // Vertices.
  float share;
};

#ifdef __cplusplus
static_assert(sizeof(AdvancePush) == 8);
}  // namespace morphgrid
#endif
#undef CONSTANT
#endif
