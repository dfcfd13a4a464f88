// A line in the colour of its first strut's strain.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/strut_line.glsl"
#include "shared/strain_color.h"

layout(binding = kBindingRest) uniform isamplerBuffer restLengths;

void main() {
  ivec3 from = placeEnd();
  int index = vertexIndex(push.size, from);
  int end = vertexIndex(push.size, neighbour(from, push.direction, 1));
  Edge e = edgeBetween(texelFetch(positions, index), texelFetch(positions, end), push.resolution);
  int rest = texelFetch(restLengths, index)[push.direction];
  lineColor = strainColor(strutStrain(e, Spring(rest, push.restResolution, 1.0)));
}
