// r = b - H z, H the Gauss-Newton Hessian of a frame.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "solve/frame_product.glsl"

layout(binding = kBindingRightSide, rgba32f) readonly uniform imageBuffer rightSide;

BarForces barForces(DeviceBarSection section, Beam beam, BarMotion z) {
  return damped(beamGaussNewtonProduct(section, beam, z), z);
}

JointForces jointForces(JointTerm term, int index) {
  return jointGaussNewtonProduct(term, imageLoad(vectors, index).xyz, imageLoad(vectors, jointCount() + index).xyz);
}

void finish(int index, vec3 force, vec3 moment) {
  int turning = jointCount() + index;
  result[index] = vec4(imageLoad(rightSide, index).xyz - force, 0.0);
  result[turning] = vec4(imageLoad(rightSide, turning).xyz - moment, 0.0);
}
