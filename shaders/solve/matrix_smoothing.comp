// A step of block-Jacobi on a coarse level: x + omega D^-1 (b - A x).
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/multigrid_types.h"
#include "solve/matrix_product.glsl"
#include "solve/point_rows.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;

layout(binding = kBindingInverse + 0u, rgba32f) readonly uniform imageBuffer inverse0;
layout(binding = kBindingInverse + 1u, rgba32f) readonly uniform imageBuffer inverse1;
layout(binding = kBindingInverse + 2u, rgba32f) readonly uniform imageBuffer inverse2;

void main() {
  matrixSize = push.size;
  ivec2 p = pointOf(push.firstRow);
  Motion step = multiply(BLOCK_AT(inverse0, inverse1, inverse2, nearestIndex(p)), residualAt(p));
  Motion x = iterateAt(p);
  if (hasPoint(matrixSize, p)) {
    STORE_MOTION(result, writtenIndex(matrixSize),
                 Motion(x.t + push.weight * step.t, x.w + push.weight * step.w));
  }
}
