// The Galerkin product P^T A P: of a coarse point's row the block in one direction of the stencil.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/multigrid_types.h"
#include "solve/interpolation.glsl"
#include "solve/point_matrix.glsl"
#include "solve/point_rows.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;

layout(std430, binding = kBindingCoarseMatrix + 0u) writeonly buffer Block0 { vec4 block0[]; };
layout(std430, binding = kBindingCoarseMatrix + 1u) writeonly buffer Block1 { vec4 block1[]; };
layout(std430, binding = kBindingCoarseMatrix + 2u) writeonly buffer Block2 { vec4 block2[]; };

// Fine blocks that lead from around the point by `offset` to around the other one.
void addBlocks(inout Block sum, ivec2 point, ivec2 offset) {
  ivec2 first = max(ivec2(-1), 2 * push.direction - offset - 1);
  ivec2 last = min(ivec2(1), 2 * push.direction - offset + 1);
  for (int v = first.y; v <= last.y; ++v) {
    for (int u = first.x; u <= last.x; ++u) {
      ivec2 row = finePointOf(point) + ivec2(u, v);
      Block a = timesRestriction(interpolationOf(row, point), blockBetween(row, offset));
      add(sum, 1.0, timesInterpolation(a, interpolationOf(row + offset, point + push.direction)));
    }
  }
}

void main() {
  matrixSize = push.fineSize;
  ivec2 point = pointOf(push.firstRow);
  if (!hasPoint(push.coarseSize, point)) {
    return;
  }
  Block sum = kNoBlock;
  [[unroll]] for (int v = -1; v <= 1; ++v) {
    [[unroll]] for (int u = -1; u <= 1; ++u) {
      addBlocks(sum, point, ivec2(u, v));
    }
  }
  STORE_BLOCK(block0, block1, block2, writtenIndex(push.coarseSize), sum);
}
