// z' = z + omega D^-1 r: a step of block-Jacobi smoothing on a frame, r = b - H z the residual.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "solve/frame_inverse.glsl"

layout(binding = kBindingVector, rgba32f) readonly uniform imageBuffer vectors;

void main() {
  int index = jointOfInvocation();
  Motion step = smoothingStep(index);
  if (isOwned()) {
    result[index] = vec4(imageLoad(vectors, index).xyz + step.t, 0.0);
    result[jointCount() + index] = vec4(imageLoad(vectors, jointCount() + index).xyz + step.w, 0.0);
  }
}
