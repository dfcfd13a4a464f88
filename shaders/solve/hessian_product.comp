// y = H z, H the Gauss-Newton Hessian.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "energy/derivative.glsl"
const int kDerivative = kGaussNewtonProduct;
#include "solve/hessian.glsl"

void finish(int index, bool owned, Vertex vertex, vec3 product, float stepPerForce) {
  if (owned) {
    result[index] = vec4(product, 0.0);
  }
}
