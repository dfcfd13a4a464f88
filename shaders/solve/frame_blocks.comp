// D^-1: the inverses of a frame's 6 x 6 blocks on the diagonal of the Gauss-Newton Hessian.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "solve/frame_blocks.glsl"
#include "solve/block_inverse.glsl"

layout(std430, binding = kBindingInverse + 0u) writeonly buffer Inverse0 { vec4 inverse0[]; };
layout(std430, binding = kBindingInverse + 1u) writeonly buffer Inverse1 { vec4 inverse1[]; };
layout(std430, binding = kBindingInverse + 2u) writeonly buffer Inverse2 { vec4 inverse2[]; };

void main() {
  ivec3 vertex = ivec3(gl_GlobalInvocationID);
  if (!hasVertex(push.grid.size, vertex)) {
    return;
  }
  Block block = kNoBlock;
  for (int axis = 0; axis < 3; ++axis) {
    for (int end = 0; end < 2; ++end) {
      ivec3 from = neighbour(vertex, axis, -end);
      if (!hasStrut(push.grid.size, from, axis)) {
        continue;
      }
      End self = End(end == 1, vec3(0));
      add(block, 1.0, betweenEnds(rowsOf(from, axis), self, self));
    }
  }
  int index = indexOf(vertex);
  if (kIsLoaded) {
    add(block, 1.0, ofHold(index, vec3(0)));
  }
  Block inverse = inverseOf(block);
  STORE_BLOCK(inverse0, inverse1, inverse2, index, inverse);
}
