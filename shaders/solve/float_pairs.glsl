// Numbers of twice a float's precision as unevaluated sums of two floats, for sums over all vertices on
// any device (T. J. Dekker, "A floating-point technique for extending the available precision", 1971).

vec2 pairSum(vec2 a, vec2 b) {
  precise float high = a.x + b.x;
  precise float share = high - a.x;
  precise float low = (a.x - (high - share)) + (b.x - share) + (a.y + b.y);
  precise float sum = high + low;
  precise float rest = low - (sum - high);
  return vec2(sum, rest);
}

// Two of them at a time.
vec4 pairSums(vec4 a, vec4 b) { return vec4(pairSum(a.xy, b.xy), pairSum(a.zw, b.zw)); }
