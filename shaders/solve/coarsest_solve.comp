// The coarsest level's motions, by its inverse: symmetric, column m of it (half a motion, four numbers)
// with rows 3 h to 3 h + 2 in the texels (3 m + n) halfMotions + h, n = 0 to 2.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/multigrid_types.h"

layout(local_size_x_id = kConstantSubgroupSize) in;

layout(binding = kBindingCoarsestInverse, rgba32f) readonly uniform imageBuffer inverse;
layout(binding = kBindingRightSide, rgba32f) readonly uniform imageBuffer rightSide;
layout(std430, binding = kBindingResult) writeonly buffer Result { vec4 result[]; };
layout(push_constant) uniform Push { CoarsestPush push; };

void main() {
  int halfMotion = int(gl_GlobalInvocationID.x);
  if (halfMotion >= push.halfMotions) {
    return;
  }
  vec3 sum = vec3(0);
  for (int m = 0; m < push.halfMotions; ++m) {
    vec3 b = imageLoad(rightSide, m).xyz;
    int first = 3 * m * push.halfMotions + halfMotion;
    sum.x += dot(imageLoad(inverse, first).xyz, b);
    sum.y += dot(imageLoad(inverse, first + push.halfMotions).xyz, b);
    sum.z += dot(imageLoad(inverse, first + 2 * push.halfMotions).xyz, b);
  }
  result[halfMotion] = vec4(sum, 0.0);
}
