// The corner constraint in closed form: energy w (|a-p|^2 + |b-q|^2), (p, q) the nearest pair of arms
// to (a, b) with p . q = 0. With t = (|a|^2 + |b|^2) / 2, s = a . b and r = 1 / sqrt(t^2 - s^2):
// gradient with respect to a: 2 w (a - p) = w (own a + other b), own = 1 - t r, other = s r, and alike
// for b. Turning an arm round changes the sign of s alone, and the formulas still hold: they take edges
// of the grid as they are, whichever end the apex is.
// A missing edge is the zero vector: s = 0 and its corners vanish.
struct Corner {
  float own;
  float other;
  Squared energy;  // per w
};

// Against 1 / 0 where edges are collinear or missing; far below the rounding of t^2 elsewhere.
const float kCollinear = 1e-14;

#ifdef PRECISE
// To more digits than r has: a step of Newton's method doubles their number.
double cornerEnergy(Edge a, Edge b, float r) {
  double s = dot(a.arm, b.arm);
  double t = 0.5 * (a.square + b.square);
  double square = (t - s) * (t + s) + kCollinear;
  double root = r * (1.5 - 0.5 * square * r * r);
  return s * s * root / (1.0 + t * root);
}
#endif

Corner projectCorner(Edge a, Edge b) {
  float s = float(dot(a.arm, b.arm));
  float t = a.halfSquare + b.halfSquare;
  float r = inversesqrt(abs((t - s) * (t + s)) + kCollinear);
  float other = s * r;
#ifdef PRECISE
  float own = -other * other / (1.0 + t * r);  // 1 - t r without its cancellation
  return Corner(own, other, cornerEnergy(a, b, r));
#else
  return Corner(1.0 - t * r, other, s * other / (1.0 + t * r));
#endif
}
