// The corner term in closed form: energy |a-p|^2 + |b-q|^2 per w, the angle weight, with (p, q) the nearest
// pair of arms to (a, b) for which p . q = 0. With t = (|a|^2 + |b|^2) / 2, s = a . b and R^2 = t^2 - s^2 it
// is s^2 / (t + R). Turning an arm round changes the sign of s alone, and all formulas still hold: they take
// edges of the grid as they are, whichever end the apex is. With a missing edge s = 0 and the term vanishes.
#ifndef MORPHGRID_ENERGY_CORNER
#define MORPHGRID_ENERGY_CORNER
#include "energy/derivative.glsl"
#include "energy/edge.glsl"

// With respect to a, per w: diagonal.x a + diagonal.y a' + coupling.x b + coupling.y b', and alike for b;
// a', b' are the edges' changes. For products with a Hessian this is how the gradient changes.
struct CornerGradient {
  vec2 diagonal;
  vec2 coupling;
  Squared energy;
};

#ifdef PRECISE
// To more digits than r has: a step of Newton's method doubles their number.
double preciseCornerEnergy(Edge a, Edge b, float r) {
  double s = dot(a.arm, b.arm);
  double t = 0.5 * (a.square + b.square);
  double square = (t - s) * (t + s) + kLeastDiscriminant;
  double root = r * (1.5 - 0.5 * square * r * r);
  return s * s * root / (1.0 + t * root);
}
#endif

// 2 (a - p) = (1 - t r) a + s r b with r = 1 / R.
CornerGradient cornerGradient(Edge a, Edge b) {
  float s = float(dot(a.arm, b.arm));
  float t = a.halfSquare + b.halfSquare;
  float r = inversesqrt(abs((t - s) * (t + s)) + kLeastDiscriminant);
  float coupling = s * r;
#ifdef PRECISE
  float diagonal = -coupling * coupling / (1.0 + t * r);  // 1 - t r without its cancellation
  Squared energy = preciseCornerEnergy(a, b, r);
#else
  float diagonal = 1.0 - t * r;
  float energy = s * coupling / (1.0 + t * r);
#endif
  return CornerGradient(vec2(diagonal, 0.0), vec2(coupling, 0.0), energy);
}

// The Gauss-Newton Hessian of a corner is weight J^T J per w. Up to a factor, J is the derivative of the
// residual s / sqrt(t + R), whose square is the energy:
// J_a = own a + other b, J_b = own b + other a, J_apex = -(J_a + J_b).
struct CornerJacobian {
  float own;
  float other;
  float weight;
};

// own = -s, other = h = t + R, weight = 1 / (2 R^2 h)
CornerJacobian cornerJacobian(Edge a, Edge b) {
  float s = dot(vec3(a.arm), vec3(b.arm));
  float t = a.halfSquare + b.halfSquare;
  float square = abs((t - s) * (t + s)) + kLeastSine2 * t * t;
  float h = t + sqrt(square);
  return CornerJacobian(-s, h, 0.5 / (square * h));
}

CornerGradient cornerGaussNewtonProduct(Edge a, Edge b) {
  CornerJacobian j = cornerJacobian(a, b);
  float across = dot(vec3(a.arm), b.change) + dot(vec3(b.arm), a.change);
  float change = j.weight * (j.own * (a.along + b.along) + j.other * across);
  return CornerGradient(vec2(j.own * change, 0.0), vec2(j.other * change, 0.0), Squared(0));
}

// With m = r^3 (t s' - s t') the gradient's factors change by -s m and t m.
CornerGradient cornerExactProduct(Edge a, Edge b) {
  float s = dot(vec3(a.arm), vec3(b.arm));
  float t = a.halfSquare + b.halfSquare;
  float r = inversesqrt(abs((t - s) * (t + s)) + kLeastSine2 * t * t);
  float coupling = s * r;
  float diagonal = -coupling * coupling / (1.0 + t * r);
  float across = dot(vec3(a.arm), b.change) + dot(vec3(b.arm), a.change);
  float m = r * r * r * (t * across - s * (a.along + b.along));
  return CornerGradient(vec2(-s * m, diagonal), vec2(t * m, coupling), Squared(0));
}

CornerGradient cornerTerm(int derivative, Edge a, Edge b) {
  if (derivative == kGradient) {
    return cornerGradient(a, b);
  }
  return derivative == kExactProduct ? cornerExactProduct(a, b) : cornerGaussNewtonProduct(a, b);
}
#endif
