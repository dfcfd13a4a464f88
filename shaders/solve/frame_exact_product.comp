// y = H z, H the exact Hessian of a frame's energy.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "energy/beam_exact.glsl"
#include "solve/frame_product.glsl"

BarForces barForces(DeviceBarSection section, Beam beam, BarMotion z) {
  return damped(beamExactProduct(section, beam, z), z);
}

JointForces jointForces(JointTerm term, int index) {
  return jointExactProduct(term, imageLoad(vectors, index).xyz, imageLoad(vectors, jointCount() + index).xyz);
}

void finish(int index, vec3 force, vec3 moment) {
  result[index] = vec4(force, 0.0);
  result[jointCount() + index] = vec4(moment, 0.0);
}
