// A strut that shows a share of its own.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/strut.glsl"

layout(binding = kBindingShares) uniform samplerBuffer shares;

layout(location = 0) flat out float share;

void main() {
  Ribbon strut = placeCorner();
  share = texelFetch(shares, strut.index)[push.direction];
}
