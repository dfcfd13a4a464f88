// As many multiplications and additions as the device can do: four vectors that do not wait for each
// other.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/probe_types.h"

layout(local_size_x = kProbeInvocations) in;

layout(binding = kBindingSource, rgba32f) readonly uniform imageBuffer source;
layout(std430, binding = kBindingDestination) writeonly buffer Destination { vec4 destination[]; };

void main() {
  uint n = gl_GlobalInvocationID.x;
  vec4 factor = imageLoad(source, int(n));
  vec4 a = factor;
  vec4 b = 2.0 * factor;
  vec4 c = 3.0 * factor;
  vec4 d = 4.0 * factor;
  for (uint step = 0u; step < kProbeSteps; ++step) {
    a = a * factor + factor;
    b = b * factor + factor;
    c = c * factor + factor;
    d = d * factor + factor;
  }
  destination[n] = a + b + c + d;
}
