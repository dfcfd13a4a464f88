// Force and torque on a column, from the forces on its vertices, and the moments where they are joints.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/frame_types.h"
#include "solve/block.glsl"
#include "solve/columns_of_points.glsl"
#include "solve/point_rows.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;
layout(constant_id = kConstantJointsTurn) const bool kJointsTurn = false;

layout(binding = kBindingFineVector, rgba32f) readonly uniform imageBuffer forces;
layout(std430, binding = kBindingResult) writeonly buffer Result { vec4 result[]; };

void main() {
  ivec2 column = pointOf(push.firstRow);
  if (!hasColumn(push.grid.size, column)) {
    return;
  }
  ivec4 centre = centreOf(column);
  Motion total = kNoMotion;
  for (int layer = 0; layer < push.grid.size.z; ++layer) {
    int vertex = indexInColumn(column, layer);
    vec3 force = imageLoad(forces, vertex).xyz;
    total.t += force;
    total.w += cross(between(centre, positionAt(column, layer)), force);
    if (kJointsTurn) {
      total.w += imageLoad(forces, vertexCount() + vertex).xyz;
    }
  }
  STORE_MOTION(result, writtenIndex(ivec2(push.grid.size)), total);
}
