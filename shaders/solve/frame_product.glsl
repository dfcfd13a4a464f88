// A product of a frame's Hessian with a vector z, at `joints`, without ever storing the matrix. An including
// kernel defines barForces(), jointForces() and finish() of frame_sum.glsl.
#define Sum float
#include "solve/frame_sum.glsl"

layout(binding = kBindingVector, rgba32f) readonly uniform imageBuffer vectors;
layout(std430, binding = kBindingResult) writeonly buffer Result { vec4 result[]; };

BarMotion barMotion(int indexA, int indexB) {
  vec3 change = imageLoad(vectors, indexB).xyz - imageLoad(vectors, indexA).xyz;
  return BarMotion(change, imageLoad(vectors, jointCount() + indexA).xyz,
                   imageLoad(vectors, jointCount() + indexB).xyz);
}

BarForces damped(BarForces forces, BarMotion z) {
  vec3 moment = push.damping * (z.turnB - z.turnA);
  return BarForces(forces.force + push.damping * z.change, forces.momentA - moment,
                   forces.momentB + moment);
}

void main() { walkColumn(); }
