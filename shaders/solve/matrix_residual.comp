// r = b - A x on a coarse level.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/multigrid_types.h"
#include "solve/matrix_product.glsl"
#include "solve/point_rows.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;

void main() {
  matrixSize = push.size;
  ivec2 p = pointOf(push.firstRow);
  Motion r = residualAt(p);
  if (hasPoint(matrixSize, p)) {
    STORE_MOTION(result, writtenIndex(matrixSize), r);
  }
}
