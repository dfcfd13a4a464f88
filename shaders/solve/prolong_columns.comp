// Adds the columns' motions to those of the vertices.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/frame_types.h"
#include "solve/block.glsl"
#include "solve/columns_of_points.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;
layout(constant_id = kConstantJointsTurn) const bool kJointsTurn = false;

layout(binding = kBindingCoarseVector, rgba32f) readonly uniform imageBuffer motions;
// One buffer twice: loads of texels are the faster ones.
layout(binding = kBindingFineVector, rgba32f) readonly uniform imageBuffer vertexMotions;
layout(std430, binding = kBindingFineResult) writeonly buffer Result { vec4 result[]; };

void main() {
  ivec2 column = ivec2(gl_GlobalInvocationID.xy);
  if (!hasColumn(push.grid.size, column)) {
    return;
  }
  ivec4 centre = centreOf(column);
  Motion motion = MOTION_AT(motions, indexInColumn(column, 0));
  for (int layer = 0; layer < push.grid.size.z; ++layer) {
    int vertex = indexInColumn(column, layer);
    vec3 lever = between(centre, positionAt(column, layer));
    vec3 moved = imageLoad(vertexMotions, vertex).xyz + motion.t + cross(motion.w, lever);
    result[vertex] = vec4(moved, 0.0);
    if (kJointsTurn) {
      int joint = vertexCount() + vertex;
      result[joint] = vec4(imageLoad(vertexMotions, joint).xyz + motion.w, 0.0);
    }
  }
}
