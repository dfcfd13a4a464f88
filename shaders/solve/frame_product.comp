// y = H z, H the Gauss-Newton Hessian of a frame.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "solve/frame_product.glsl"

BarForces barForces(DeviceBarSection section, Beam beam, BarMotion z) {
  return damped(beamGaussNewtonProduct(section, beam, z), z);
}

JointForces jointForces(JointTerm term, int index) {
  return jointGaussNewtonProduct(term, imageLoad(vectors, index).xyz, imageLoad(vectors, jointCount() + index).xyz);
}

void finish(int index, vec3 force, vec3 moment) {
  result[index] = vec4(force, 0.0);
  result[jointCount() + index] = vec4(moment, 0.0);
}
