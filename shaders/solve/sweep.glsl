// One sweep of Jacobi-style projective dynamics with Chebyshev acceleration: every strut and corner is
// projected, every vertex takes the weighted mean of what its constraints want.
#include "energy/derivative.glsl"
#include "shared/solver_types.h"

const int kDerivative = kGradient;

layout(constant_id = kConstantMeasures) const bool kMeasure = false;

// One buffer twice, as loads of texels are the faster ones. A vertex's entry is loaded, then stored, by
// the one invocation that moves the vertex.
layout(binding = kBindingPreviousPositions, rgba32i) readonly uniform iimageBuffer previous;
layout(std430, binding = kBindingNextPositions) writeonly buffer NextPositions { ivec4 next[]; };
layout(std430, binding = kBindingState) readonly buffer State { SolverState state; };
layout(std430, binding = kBindingPartials) writeonly buffer Partials { vec4 partials[]; };
layout(push_constant) uniform Push { SweepPush push; };

#define GRID push.grid
#define DAMPING 0.0
#define Sum float
#include "solve/columns.glsl"

shared vec4 sums[kLargestSubgroup];

// Spacings that a vertex may move in one sweep; keeps a wild start within the fixed-point range.
const float kLargestMove = 1.0;
const float kRelaxation = 0.9;

float momentum;
float squaredGradient = 0.0;
float gradientAlongVelocity = 0.0;

// Chebyshev semi-iteration whose assumed condition grows with the sweeps since the last restart.
float chebyshevMomentum() {
  float sweeps = float(state.sweepsSinceRestart + push.sweep);
  float root = sweeps / (sweeps + 2.0);
  return root * root;
}

Vertex vertexAt(int index) { return Vertex(imageLoad(positions, index), vec3(0)); }

void finish(int index, bool owned, Vertex vertex, vec3 gradient, float stepPerForce) {
  vec3 velocity = stepsBetween(imageLoad(previous, index), vertex.position);
  vec3 jump = -(1.0 + momentum) * kRelaxation * stepPerForce / GRID.resolution * gradient;
  float largest = kLargestMove / GRID.resolution;
  ivec4 target = moved(vertex.position, clamp(momentum * velocity + jump, -largest, largest));
  if (owned) {
    next[index] = target;
  }
  if (kMeasure && owned) {
    squaredGradient += dot(gradient, gradient);
    gradientAlongVelocity += dot(gradient, velocity) * GRID.resolution;
  }
}

// Pairwise sums over the workgroup: accurate and the same in every run.
void writePartials() {
  uint lane = gl_LocalInvocationIndex;
  sums[lane] = vec4(energy, squaredGradient, gradientAlongVelocity, 0.0);
  for (uint stride = gl_WorkGroupSize.x / 2u; stride > 0u; stride /= 2u) {
    barrier();
    if (lane < stride) {
      sums[lane] += sums[lane + stride];
    }
  }
  if (lane == 0u) {
    partials[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = sums[0];
  }
}

void main() {
  findRing(state.done == 0u);
  momentum = chebyshevMomentum();
  walkColumns();
  if (kMeasure) {
    writePartials();
  }
}
