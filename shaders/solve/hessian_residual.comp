// r = b - H z, H the Gauss-Newton Hessian.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "energy/derivative.glsl"
const int kDerivative = kGaussNewtonProduct;
#include "solve/hessian.glsl"

layout(binding = kBindingRightSide, rgba32f) readonly uniform imageBuffer rightSide;

void finish(int index, bool owned, Vertex vertex, vec3 product, float stepPerForce) {
  vec3 residual = imageLoad(rightSide, index).xyz - product;
  if (owned) {
    result[index] = vec4(residual, 0.0);
  }
}
