// After a measured sweep: adds up the workgroups' partial sums, records a sample, restarts the
// acceleration where it leads uphill, and says when the residual is small enough.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/solver_types.h"

layout(local_size_x = kControlInvocations) in;

layout(std430, binding = kBindingState) buffer State { SolverState state; };
layout(std430, binding = kBindingPartials) readonly buffer Partials { vec4 partials[]; };
layout(std430, binding = kBindingSamples) writeonly buffer Samples { SolverSample samples[]; };
layout(push_constant) uniform Push { ControlPush push; };

shared vec4 sums[kControlInvocations];

void main() {
  uint lane = gl_LocalInvocationIndex;
  vec4 sum = vec4(0);
  for (uint n = lane; n < push.partialCount; n += kControlInvocations) {
    sum += partials[n];
  }
  sums[lane] = sum;
  for (uint stride = kControlInvocations / 2u; stride > 0u; stride /= 2u) {
    barrier();
    if (lane < stride) {
      sums[lane] += sums[lane + stride];
    }
  }
  if (lane != 0u || state.done != 0u) {
    return;
  }
  float residual = sqrt(sums[0].y) * push.residualScale;
  if (state.sampleCount < push.sampleCapacity) {
    samples[state.sampleCount] = SolverSample(sums[0].x, residual);
  }
  state.sampleCount += 1u;
  state.done = residual <= state.tolerance ? 1u : 0u;
  bool uphill = sums[0].z > 0.0;
  state.sweepsSinceRestart = uphill ? 0u : state.sweepsSinceRestart + kSweepsPerCheck;
}
