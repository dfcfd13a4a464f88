// The centres of a coarser level, and what its transfers need of every fine point: 2 x - xbar, a position.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/multigrid_types.h"
#include "solve/transfer.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;

layout(binding = kBindingCentres, rgba32i) readonly uniform iimageBuffer centres;
layout(std430, binding = kBindingCoarseCentres) writeonly buffer Coarse { ivec4 coarseCentres[]; };
layout(std430, binding = kBindingLevers) writeonly buffer Levers { ivec4 levers[]; };

ivec4 centreOf(ivec2 coarse) {
  return imageLoad(centres, fineIndex(finePointOf(coarse)));
}

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (!hasPoint(push.fineSize, p)) {
    return;
  }
  int point = fineIndex(p);
  ivec4 centre = imageLoad(centres, point);
  vec3 offset = vec3(0);  // x - xbar
  [[unroll]] for (int v = 0; v < 2; ++v) {
    [[unroll]] for (int u = 0; u < 2; ++u) {
      ivec2 coarse = firstCoarse(p) + ivec2(u, v);
      offset += shareOf(p, coarse) * vec3(centre.xyz - centreOf(coarse).xyz);
    }
  }
  levers[point] = ivec4(centre.xyz + ivec3(round(offset)), 0);
  vec2 second = secondShares(p);
  if (second == floor(second)) {
    coarseCentres[coarseIndex(firstCoarse(p) + ivec2(second))] = centre;
  }
}
