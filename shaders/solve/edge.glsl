// What struts and corners need to know of an edge, and the stretch of struts.
#include "solve/arm.glsl"

// From one vertex to its neighbour.
struct Edge {
  Arm arm;
  Squared square;
  float halfSquare;
};

Edge edgeBetween(ivec4 from, ivec4 to, float resolution) {
  Arm arm = armBetween(from, to, resolution);
  Squared square = dot(arm, arm);
  return Edge(arm, square, 0.5 * float(square));
}

// |e| - L from |e|^2; rest = L in steps of restResolution.
float lengthExcess(Squared square, int rest, float restResolution) {
#ifdef PRECISE
  double restLength = double(rest) * double(restResolution);
  double difference = square - restLength * restLength;
  return float(difference) / max(sqrt(float(square)) + float(restLength), 1e-20);  // 0 / 0: no strut
#else
  return sqrt(square) - float(rest) * restResolution;
#endif
}

// 1 - L / |e|
float relativeStretch(Edge e, int rest, float restResolution) {
  float inverseLength = inversesqrt(float(e.square) + 1e-20);  // 1 / 0: no strut
#ifdef PRECISE
  return lengthExcess(e.square, rest, restResolution) * inverseLength;
#else
  return 1.0 - float(rest) * restResolution * inverseLength;
#endif
}
