// The surface of the middle layer, and the shares of its columns.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/surface.glsl"

layout(binding = kBindingShares) uniform samplerBuffer shares;

layout(location = 3) centroid out float share;

float shareAt(ivec2 drawn) {
  return texelFetch(shares, pointIndex(push.size.xy, columnAt(drawn))).a;
}

// Linear between vertices: a spline would leave their range.
void main() {
  ivec2 lattice = placeVertex();
  ivec2 low = min(lattice / push.refine, push.drawnSize - 2);
  vec2 t = vec2(lattice - low * push.refine) / float(push.refine);
  float front = mix(shareAt(low), shareAt(low + ivec2(1, 0)), t.x);
  float back = mix(shareAt(low + ivec2(0, 1)), shareAt(low + ivec2(1, 1)), t.x);
  share = mix(front, back, t.y);
}
