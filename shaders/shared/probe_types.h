// Compiles as GLSL and as C++: what the host and the kernels that measure a device agree on.
#ifndef MORPHGRID_PROBE_TYPES_H
#define MORPHGRID_PROBE_TYPES_H
#include "shared/solver_types.h"
#ifdef __cplusplus
namespace morphgrid {
#define CONSTANT constexpr
#else
#define CONSTANT const
#endif

CONSTANT uint kBindingSource = 0u;       // texels, vec4
CONSTANT uint kBindingDestination = 1u;  // buffer, vec4

CONSTANT uint kProbeInvocations = 128u;
CONSTANT uint kProbeSteps = 256u;   // Steps of arithmetic.comp in each invocation.
CONSTANT uint kFlopsPerStep = 32u;  // In arithmetic.comp: four vec4, multiplied and added.

#ifdef __cplusplus
}  // namespace morphgrid
#endif
#undef CONSTANT
#endif
