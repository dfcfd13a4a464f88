// The Gauss-Newton Hessian of a corner is 2 w J^T J, J the derivative of its residual
// r = s sqrt(2 / (T + D)), whose square is half its energy per w. With t = T / 2 = (|a|^2 + |b|^2) / 2,
// s = a . b, R = D / 2 = sqrt(t^2 - s^2) and h = t + R, r = s / sqrt(h) and
//   J_a = scale (h b - s a),  J_b = scale (h a - s b),  J_apex = -(J_a + J_b),  2 scale^2 = 1 / (2 R^2 h).
// Turning an arm round changes the sign of s alone, and of J_a or J_b with it: as in corner.glsl edges are
// taken as they are.

struct CornerDerivative {
  float s;
  float h;
  float doubleSquare;  // 2 R^2
};

// Keeps R away from 0 where arms are collinear: there the residual has no derivative.
const float kLeastSine2 = 1e-6;

// halfA, halfB: |a|^2 / 2 and |b|^2 / 2, one of them > 0.
CornerDerivative differentiateCorner(vec3 a, vec3 b, float halfA, float halfB) {
  float s = dot(a, b);
  float t = halfA + halfB;
  float square = abs((t - s) * (t + s)) + kLeastSine2 * t * t;
  return CornerDerivative(s, t + sqrt(square), 2.0 * square);
}
