// Fixed-point positions (shared/solver_types.h), and the arms between them: exact integer differences,
// in spacings; single precision, or double with PRECISE. Near equilibrium the rounding of
// differences in single precision, and nothing else, sets the smallest residual.
#ifndef MORPHGRID_ENERGY_ARM
#define MORPHGRID_ENERGY_ARM
#include "shared/solver_types.h"

#ifdef PRECISE
#define Arm dvec3
#define Squared double
#else
#define Arm vec3
#define Squared float
#endif

const int kExtraMask = (1 << kExtraBits) - 1;
const float kExtraSteps = float(1 << kExtraBits);

ivec3 extraBits(ivec4 p) {
  return (ivec3(p.w) >> ivec3(0, kExtraBits, 2 * kExtraBits)) & kExtraMask;
}

// In steps of the fixed point, with the extra bits.
vec3 stepsBetween(ivec4 from, ivec4 to) {
  return vec3(to.xyz - from.xyz) + vec3(extraBits(to) - extraBits(from)) / kExtraSteps;
}

Arm armBetween(ivec4 from, ivec4 to, float resolution) {
#ifdef PRECISE
  dvec3 steps = dvec3(to.xyz - from.xyz) +
                dvec3(extraBits(to) - extraBits(from)) * (1.0 / double(kExtraSteps));
  return steps * double(resolution);
#else
  return vec3(to.xyz - from.xyz) * resolution;
#endif
}

// Where a vertex is `delta` steps further on. Lavapipe stores lane by lane, and its compiler would
// repeat for every lane whatever additions and shifts by constants come last: the conversion and the max
// keep them out of that loop.
ivec4 moved(ivec4 p, vec3 delta) {
  vec3 fine = delta + (vec3(extraBits(p)) + 0.5) / kExtraSteps;
  vec3 whole = floor(fine);
  ivec3 extra = min(ivec3((fine - whole) * kExtraSteps), kExtraMask);
  int extras = extra.x | (extra.y << kExtraBits) | (extra.z << (2 * kExtraBits));
  return ivec4(p.xyz + ivec3(whole), max(extras, 0));
}
#endif
