// The corner term in closed form: energy |a-p|^2 + |b-q|^2 per w, the weight of the angle, with (p, q) the
// nearest pair of arms to (a, b) at the corner's rest angle theta. With t = (|a|^2 + |b|^2) / 2, A = |a x b|,
// s = a . b sin theta - A cos theta and R^2 = t^2 - s^2 it is s^2 / (t + R). Turning an arm round, and theta
// with it, changes the sign of s alone, and all formulas still hold: they take edges of the grid as they are,
// whichever end the apex is. With a missing edge s = 0 and the term vanishes.
#ifndef MORPHGRID_ENERGY_CORNER
#define MORPHGRID_ENERGY_CORNER
#include "energy/derivative.glsl"
#include "energy/edge.glsl"

// Rest angles are (cos theta, sin theta). Compilers drop what a right angle makes 0.
const vec2 kRightAngle = vec2(0.0, 1.0);

// The rest angle between the directions of two edges in the plane.
vec2 restAngleBetween(vec2 a, vec2 b) { return vec2(dot(a, b), abs(a.x * b.y - a.y * b.x)); }

// With respect to a, per w: ofA.x a + ofA.y a' + coupling.x b + coupling.y b', and alike for b; a', b' are
// the edges' changes. For products with a Hessian this is how the gradient changes.
struct CornerGradient {
  vec2 ofA;
  vec2 ofB;
  vec2 coupling;
  Squared energy;
};

// s, and its derivative by a: across b - along |b|^2 a, and alike by b.
struct CornerSine {
  Squared s;
  float across;
  float along;
};

CornerSine cornerSine(Edge a, Edge b, vec2 rest) {
  Squared product = dot(a.arm, b.arm);
  Arm normal = cross(a.arm, b.arm);
  Squared area = sqrt(dot(normal, normal));
  float along = rest.x / max(float(area), kLeastSine * (a.halfSquare + b.halfSquare));
  return CornerSine(product * Squared(rest.y) - area * Squared(rest.x),
                    rest.y + along * float(product), along);
}

#ifdef PRECISE
// To more digits than r has: a step of Newton's method doubles their number.
double preciseCornerEnergy(double s, Edge a, Edge b, float r) {
  double t = 0.5 * (a.square + b.square);
  double square = (t - s) * (t + s) + kLeastDiscriminant;
  double root = r * (1.5 - 0.5 * square * r * r);
  return s * s * root / (1.0 + t * root);
}
#endif

// 2 (a - p) = (1 - t r) a + s r s' with r = 1 / R, s' the derivative of s by a.
CornerGradient cornerGradient(Edge a, Edge b, vec2 rest) {
  CornerSine sine = cornerSine(a, b, rest);
  float s = float(sine.s);
  float t = a.halfSquare + b.halfSquare;
  float r = inversesqrt(abs((t - s) * (t + s)) + kLeastDiscriminant);
  float coupling = s * r;
#ifdef PRECISE
  float diagonal = -coupling * coupling / (1.0 + t * r);  // 1 - t r without its cancellation
  Squared energy = preciseCornerEnergy(sine.s, a, b, r);
#else
  float diagonal = 1.0 - t * r;
  float energy = s * coupling / (1.0 + t * r);
#endif
  float along = coupling * sine.along;
  return CornerGradient(vec2(diagonal - along * float(b.square), 0.0),
                        vec2(diagonal - along * float(a.square), 0.0),
                        vec2(coupling * sine.across, 0.0), energy);
}

// The Gauss-Newton Hessian of a corner is weight J^T J per w. Up to a factor, J is the derivative of the
// residual s / sqrt(t + R), whose square is the energy:
// J_a = ownA a + other b, J_b = ownB b + other a, J_apex = -(J_a + J_b).
struct CornerJacobian {
  float ownA;
  float ownB;
  float other;
  float weight;
};

// J_a = h s' - s a with h = t + R, weight = 1 / (2 R^2 h)
CornerJacobian cornerJacobian(Edge a, Edge b, vec2 rest) {
  CornerSine sine = cornerSine(a, b, rest);
  float s = float(sine.s);
  float t = a.halfSquare + b.halfSquare;
  float square = abs((t - s) * (t + s)) + kLeastSine2 * t * t;
  float h = t + sqrt(square);
  float along = h * sine.along;
  return CornerJacobian(-s - along * float(b.square), -s - along * float(a.square),
                        h * sine.across, 0.5 / (square * h));
}

CornerGradient cornerGaussNewtonProduct(Edge a, Edge b, vec2 rest) {
  CornerJacobian j = cornerJacobian(a, b, rest);
  float across = dot(vec3(a.arm), b.change) + dot(vec3(b.arm), a.change);
  float change = j.weight * (j.ownA * a.along + j.ownB * b.along + j.other * across);
  return CornerGradient(vec2(j.ownA * change, 0.0), vec2(j.ownB * change, 0.0),
                        vec2(j.other * change, 0.0), Squared(0));
}

// With m = r^3 (t s' - s t') the gradient's factors of a and of the derivative of s change by -s m and t m,
// and A by growth A.
CornerGradient cornerExactProduct(Edge a, Edge b, vec2 rest) {
  CornerSine sine = cornerSine(a, b, rest);
  float s = float(sine.s);
  float t = a.halfSquare + b.halfSquare;
  float squareA = float(a.square), squareB = float(b.square);
  float product = dot(vec3(a.arm), vec3(b.arm));
  float r = inversesqrt(abs((t - s) * (t + s)) + kLeastSine2 * t * t);
  float coupling = s * r;
  float diagonal = -coupling * coupling / (1.0 + t * r);
  float across = dot(vec3(a.arm), b.change) + dot(vec3(b.arm), a.change);
  float ofSquares = squareB * a.along + squareA * b.along;
  float change = sine.across * across - sine.along * ofSquares;
  float m = r * r * r * (t * change - s * (a.along + b.along));
  float areaSquare = max(squareA * squareB - product * product, kLeastSine2 * t * t);
  float alongChange = -sine.along * (ofSquares - product * across) / areaSquare;
  float acrossChange = alongChange * product + sine.along * across;
  float own = coupling * alongChange + t * m * sine.along;
  float twice = 2.0 * coupling * sine.along;
  return CornerGradient(
      vec2(-s * m - own * squareB - twice * b.along, diagonal - coupling * sine.along * squareB),
      vec2(-s * m - own * squareA - twice * a.along, diagonal - coupling * sine.along * squareA),
      vec2(t * m * sine.across + coupling * acrossChange, coupling * sine.across), Squared(0));
}

CornerGradient cornerTerm(int derivative, Edge a, Edge b, vec2 rest) {
  if (derivative == kGradient) {
    return cornerGradient(a, b, rest);
  }
  return derivative == kExactProduct ? cornerExactProduct(a, b, rest)
                                     : cornerGaussNewtonProduct(a, b, rest);
}
#endif
