// A x at a point, x the level's iterate.
#include "solve/block.glsl"
#include "solve/point_matrix.glsl"

layout(binding = kBindingIterate, rgba32f) readonly uniform imageBuffer iterate;
layout(binding = kBindingRightSide, rgba32f) readonly uniform imageBuffer rightSide;
layout(std430, binding = kBindingResult) writeonly buffer Result { vec4 result[]; };
layout(push_constant) uniform Push { SmoothingPush push; };

// Beyond the border nothing moves, so blocks that lead there do not matter.
Motion iterateAt(ivec2 p) {
  Motion x = MOTION_AT(iterate, nearestIndex(p));
  float share = hasPoint(matrixSize, p) ? 1.0 : 0.0;
  return Motion(share * x.t, share * x.w);
}

// What the blocks between p and p + offset, and p and p - offset, do at p.
#define PAIR(block, p, offset)                                              \
  sum(multiply(block(nearestIndex(p)), iterateAt((p) + (offset))),            \
      multiplyTransposed(block(nearestIndex((p) - (offset))), iterateAt((p) - (offset))))

Motion productAt(ivec2 p) {
  Motion y = multiply(selfBlock(nearestIndex(p)), iterateAt(p));
  y = sum(y, PAIR(eastBlock, p, ivec2(1, 0)));
  y = sum(y, PAIR(northBlock, p, ivec2(0, 1)));
  y = sum(y, PAIR(northEastBlock, p, ivec2(1, 1)));
  return sum(y, PAIR(northWestBlock, p, ivec2(-1, 1)));
}

Motion residualAt(ivec2 p) {
  Motion b = MOTION_AT(rightSide, nearestIndex(p));
  Motion y = productAt(p);
  return Motion(b.t - y.t, b.w - y.w);
}
