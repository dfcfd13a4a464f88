// A product of a Hessian with a vector z, at `positions`, without ever storing the matrix. An including kernel
// defines kDerivative (energy/derivative.glsl) before, and finish(), which gets a vertex's part of H z as its
// gradient.
#include "shared/hessian_types.h"

const int kBlockU = int(kSweepBlockU);
const int kBlockV = int(kHessianBlockV);
const bool kMeasure = false;

layout(binding = kBindingVector, rgba32f) readonly uniform imageBuffer vectors;
layout(std430, binding = kBindingResult) writeonly buffer Result { vec4 result[]; };
layout(push_constant) uniform Push { HessianPush push; };

#define GRID push.grid
#define DAMPING push.damping
#define Sum float
#include "solve/columns.glsl"

Vertex vertexAt(int index) {
  return Vertex(imageLoad(positions, index), imageLoad(vectors, index).xyz);
}

void main() {
  findRing(true);
  walkColumns();
}
