// The corner constraint in closed form: energy w (|a-p|^2 + |b-q|^2), (p, q) the nearest pair of arms
// to (a, b) with p . q = 0. With T = |a|^2 + |b|^2, s = a . b, D = sqrt(T^2 - 4 s^2):
// gradient at the end of a: 2 w (a - p) = w (own a + other b), and alike at b.
// A missing arm is the zero vector: s = 0 and its corners vanish.
struct Corner {
  float own;
  float other;
  float energy;  // per w
};

Corner projectCorner(Arm a, Arm b, Squared aa, Squared bb) {
  float s = float(dot(a, b));
  float t = float(aa) + float(bb);
  float ss4 = 4.0 * s * s;
  float d = sqrt(max(t * t - ss4, 1e-12 * t * t + 1e-30));  // Collinear arms: D -> 0.
  float sum = t + d;
  float inverse = 1.0 / (d * sum);
  return Corner(-ss4 * inverse, 2.0 * s * sum * inverse, 0.5 * ss4 * d * inverse);
}
