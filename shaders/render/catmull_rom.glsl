// A segment of a Catmull-Rom spline: weights of the point before it, of its ends, and of the point after
// it, at t in 0 .. 1.
vec4 pointWeights(float t) {
  return 0.5 * vec4(t * (-1 + t * (2 - t)), 2 + t * t * (3 * t - 5), t * (1 + t * (4 - 3 * t)),
                    t * t * (t - 1));
}

vec4 tangentWeights(float t) {
  return 0.5 * vec4(-1 + t * (4 - 3 * t), t * (9 * t - 10), 1 + t * (8 - 9 * t), t * (3 * t - 2));
}
