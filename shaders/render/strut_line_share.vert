// A line in the colour of its first strut's share.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/strut_line.glsl"
#include "shared/share_color.h"

layout(binding = kBindingShares) uniform samplerBuffer shares;

void main() {
  int index = vertexIndex(push.size, placeEnd());
  lineColor = shareColor(texelFetch(shares, index)[push.direction]);
}
