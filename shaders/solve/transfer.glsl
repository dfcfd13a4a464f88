// Between a level and the next coarser one: n points in a row become n / 2 + 1, the I-th of them at fine
// point min(2 I, n - 1). A fine point's motion is interpolated from the coarse points C around it, with
// bilinear shares phi, so that they are linked (constant curvature and twist stay free of shear):
//   t = sum phi (t_C + w_C x y_C),  w = sum phi w_C,  y_C = x - (xbar + x_C) / 2,  xbar = sum phi x_C.
#include "shared/topology.h"

layout(push_constant) uniform Push { TransferPush push; };

int fineIndex(ivec2 p) { return pointIndex(push.fineSize, nearestPoint(push.fineSize, p)); }

int coarseIndex(ivec2 p) { return pointIndex(push.coarseSize, nearestPoint(push.coarseSize, p)); }

ivec2 finePointOf(ivec2 coarse) { return min(2 * coarse, push.fineSize - 1); }

// The first of the 2 x 2 coarse points around a fine one.
ivec2 firstCoarse(ivec2 fine) { return min(fine / 2, push.coarseSize - 2); }

// The shares of the second coarse point in each direction; those of the first are the rest to 1.
vec2 secondShares(ivec2 fine) {
  ivec2 first = finePointOf(firstCoarse(fine));
  ivec2 second = finePointOf(firstCoarse(fine) + 1);
  return vec2(fine - first) / vec2(second - first);
}

// phi, 0 for any other coarse point, and beyond the borders.
float shareOf(ivec2 fine, ivec2 coarse) {
  ivec2 steps = coarse - firstCoarse(fine);
  vec2 second = secondShares(fine);
  vec2 share = mix(mix(vec2(0), second, equal(steps, ivec2(1))), 1.0 - second, equal(steps, ivec2(0)));
  return hasPoint(push.fineSize, fine) ? share.x * share.y : 0.0;
}

// y_C, from 2 x - xbar (levers.comp).
vec3 leverBetween(ivec4 centre, ivec4 lever) {
  return vec3(lever.xyz - centre.xyz) * (0.5 * push.resolution);
}
