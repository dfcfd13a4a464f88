// Copies texels in the way in which the solver reads and writes its vectors.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/probe_types.h"

layout(local_size_x = kProbeInvocations) in;

layout(binding = kBindingSource, rgba32f) readonly uniform imageBuffer source;
layout(std430, binding = kBindingDestination) writeonly buffer Destination { vec4 destination[]; };

void main() {
  uint n = gl_GlobalInvocationID.x;
  destination[n] = imageLoad(source, int(n));
}
