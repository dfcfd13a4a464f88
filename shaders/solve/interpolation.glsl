// Between a level of points and the next coarser one. A fine point's motion is interpolated from the coarse
// points C around it, with bilinear shares phi (transfer.glsl):
//   t = sum phi (t_C + w_C x y_C),  w = sum phi w_C + 3/2 sum of beta,  y_C = x - (xbar + x_C) / 2,  xbar = sum phi x_C.
// beta is by how much the chord d = x_N - x_C of a line of the grid that the point is in the middle of turns more
// than the motions at its ends (of two such lines, side by side, the mean):
//   beta = d x (t_N - t_C - (w_C + w_N) / 2 x d) / (|d|^2 + s^2).
// With s = 0 that is Hermite's interpolation of a beam: where it bends, however unevenly, nothing shears. Below the
// length s lines shear rather than bend (shear_length.h).
#include "solve/block.glsl"
#include "solve/transfer.glsl"

layout(binding = kBindingCoarseCentres, rgba32i) readonly uniform iimageBuffer coarseCentres;
layout(binding = kBindingLevers, rgba32i) readonly uniform iimageBuffer levers;

// A coarse point's part of a fine one's motion: t = share (t_C + w_C x lever), w = share (spin w_C - turn x t_C).
struct Interpolation {
  float share;
  vec3 lever, turn;
  mat3 spin;  // Symmetric.
};

ivec4 centreOf(ivec2 coarse) { return imageLoad(coarseCentres, coarseIndex(coarse)); }

void addLine(inout Interpolation p, ivec4 centre, ivec2 other, float secondShare) {
  vec3 chord = vec3(centreOf(other).xyz - centre.xyz) * push.resolution;
  float squared = dot(chord, chord);
  float weight = secondShare == 0.5 ? 3.0 / (squared + push.shearSquared) : 0.0;
  p.turn += weight * chord;
  p.spin += 0.5 * weight * (outerProduct(chord, chord) - mat3(squared));
}

Interpolation interpolationOf(ivec2 fine, ivec2 coarse) {
  ivec4 centre = centreOf(coarse);
  vec3 lever = leverBetween(centre, imageLoad(levers, fineIndex(fine)));
  Interpolation p = Interpolation(shareOf(fine, coarse), lever, vec3(0), mat3(1));
  vec2 second = secondShares(fine);
  ivec2 across = 2 * firstCoarse(fine) + 1 - coarse;
  addLine(p, centre, ivec2(across.x, coarse.y), second.x);
  addLine(p, centre, ivec2(coarse.x, across.y), second.y);
  return p;
}

Motion interpolated(Interpolation p, Motion c) {
  return Motion(p.share * (c.t + cross(c.w, p.lever)), p.share * (p.spin * c.w - cross(p.turn, c.t)));
}

// The transpose: force and torque on the coarse point.
Motion restricted(Interpolation p, Motion f) {
  return Motion(p.share * (f.t + cross(p.turn, f.w)), p.share * (p.spin * f.w + cross(p.lever, f.t)));
}

// a P
Block timesInterpolation(Block a, Interpolation p) {
  return Block(p.share * (a.tt + crossedFromRight(a.tw, p.turn)),
               p.share * (crossedFromRight(a.tt, p.lever) + a.tw * p.spin),
               p.share * (a.wt + crossedFromRight(a.ww, p.turn)),
               p.share * (crossedFromRight(a.wt, p.lever) + a.ww * p.spin));
}

// P^T a
Block timesRestriction(Interpolation p, Block a) {
  return Block(p.share * (a.tt + crossed(p.turn, a.wt)), p.share * (a.tw + crossed(p.turn, a.ww)),
               p.share * (p.spin * a.wt + crossed(p.lever, a.tt)),
               p.share * (p.spin * a.ww + crossed(p.lever, a.tw)));
}
