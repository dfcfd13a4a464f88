// z = omega D^-1 b: a step of block-Jacobi smoothing from zero on a frame.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "solve/frame_inverse.glsl"

void main() {
  int index = jointOfInvocation();
  Motion step = smoothingStep(index);
  if (isOwned()) {
    result[index] = vec4(step.t, 0.0);
    result[jointCount() + index] = vec4(step.w, 0.0);
  }
}
