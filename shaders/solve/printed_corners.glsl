// The angles at which corners in a layer rest: as printed, or right ones.
#ifndef MORPHGRID_SOLVE_PRINTED_CORNERS
#define MORPHGRID_SOLVE_PRINTED_CORNERS
#include "energy/corner.glsl"
#include "shared/solver_types.h"
#include "shared/topology.h"

layout(constant_id = kConstantPrintedCorners) const bool kPrintedCorners = false;

layout(binding = kBindingPrinted, rgba32f) readonly uniform imageBuffer printed;

// The printed direction of an arm, between neighbours in a layer; any where there is none.
vec2 printedArm(ivec3 size, ivec3 apex, ivec3 end) {
  ivec3 from = clamp(min(apex, end), ivec3(0), size - 1);
  vec4 directions = imageLoad(printed, vertexIndex(size, from));
  vec2 direction = apex.x != end.x ? directions.xy : directions.zw;
  return from == apex ? direction : -direction;
}

// The rest angle of the corner that neighbours in a layer have at an apex; others' are right ones.
vec2 restAngleAt(ivec3 size, ivec3 apex, ivec3 a, ivec3 b) {
  if (!kPrintedCorners || a.z != apex.z || b.z != apex.z) {
    return kRightAngle;
  }
  return restAngleBetween(printedArm(size, apex, a), printedArm(size, apex, b));
}
#endif
