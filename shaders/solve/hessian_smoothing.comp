// z' = z + omega D^-1 (b - H z): a step of block-Jacobi smoothing.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "solve/hessian.glsl"
#include "solve/inverse_blocks.glsl"

layout(binding = kBindingRightSide, rgba32f) readonly uniform imageBuffer rightSide;

void finish(int index, bool owned, Vertex vertex, vec3 product, float stepPerForce) {
  vec3 residual = imageLoad(rightSide, index).xyz - product;
  vec3 smoothed = vertex.z + push.weight * multiplyInverse(index, residual);
  if (owned) {
    result[index] = vec4(smoothed, 0.0);
  }
}
