// y = H z, H the exact Hessian of the energy.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "energy/derivative.glsl"
const int kDerivative = kExactProduct;
#include "solve/hessian.glsl"

void finish(int index, bool owned, Vertex vertex, vec3 product, float stepPerForce) {
  if (owned) {
    result[index] = vec4(product, 0.0);
  }
}
