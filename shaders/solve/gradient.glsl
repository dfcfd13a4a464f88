// Energy and its gradient. Lengths in spacings, energies in stiffness x spacing^2.
#include "energy/derivative.glsl"
#include "shared/hessian_types.h"
#include "solve/float_pairs.glsl"

const int kDerivative = kGradient;
const bool kMeasure = true;

layout(std430, binding = kBindingResult) writeonly buffer Result { vec4 gradients[]; };
layout(std430, binding = kBindingPartials) writeonly buffer Partials { vec4 partials[]; };
layout(push_constant) uniform Push { GridPush push; };

#define GRID push
#define DAMPING 0.0
#ifdef PRECISE
#define Sum double
#else
#define Sum float
#endif
#include "solve/columns.glsl"

shared vec4 sums[kLargestSubgroup];

Sum squaredGradient = Sum(0);

Vertex vertexAt(int index) { return Vertex(imageLoad(positions, index), vec3(0)); }

void finish(int index, bool owned, Vertex vertex, vec3 gradient, float stepPerForce) {
  if (owned) {
    gradients[index] = vec4(gradient, 0.0);
  }
  squaredGradient += owned ? dot(gradient, gradient) : 0.0;
}

vec2 pairOf(Sum sum) {
  float high = float(sum);
  return vec2(high, float(sum - Sum(high)));
}

// Pairwise sums over the workgroup: accurate and the same in every run.
void writePartials() {
  uint lane = gl_LocalInvocationIndex;
  sums[lane] = vec4(pairOf(energy), pairOf(squaredGradient));
  for (uint stride = gl_WorkGroupSize.x / 2u; stride > 0u; stride /= 2u) {
    barrier();
    if (lane < stride) {
      sums[lane] = pairSums(sums[lane], sums[lane + stride]);
    }
  }
  if (lane == 0u) {
    partials[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = sums[0];
  }
}

void main() {
  findRing(true);
  walkColumns();
  writePartials();
}
