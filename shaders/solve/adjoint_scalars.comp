// The scalars of conjugate gradients from the sums that adjoint_dots.comp left: one workgroup.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/adjoint_types.h"

layout(local_size_x = kVectorInvocations) in;

layout(std430, binding = kBindingProducts) readonly buffer Products { vec2 products[]; };
layout(std430, binding = kBindingScalars) buffer Scalars { ConjugateScalars scalars; };
layout(push_constant) uniform Push { ScalarsPush push; };

shared vec2 sums[kVectorInvocations];

void takeProduct(float curvature) {
  // Written so that what is no number counts as not positive.
  scalars.isNotPositive = curvature > 0 ? scalars.isNotPositive : 1;
  scalars.step = scalars.isNotPositive == 0 ? scalars.mixed / curvature : 0;
}

void takeRemainder(vec2 sum) {
  scalars.turn = scalars.mixed > 0 ? sum.x / scalars.mixed : 0;
  scalars.mixed = sum.x;
  scalars.squared = sum.y;
}

void main() {
  uint lane = gl_LocalInvocationIndex;
  vec2 sum = vec2(0);
  for (uint n = lane; n < push.groups; n += kVectorInvocations) {
    sum += products[n];
  }
  sums[lane] = sum;
  for (uint reach = kVectorInvocations / 2u; reach > 0u; reach /= 2u) {
    barrier();
    if (lane < reach) {
      sums[lane] += sums[lane + reach];
    }
  }
  if (lane != 0u) {
    return;
  }
  if (push.stage == kScalarsOfProduct) {
    takeProduct(sums[0].x);
  } else {
    takeRemainder(sums[0]);
  }
}
