// An edge of the grid, from a vertex to its neighbour. All terms of the energy depend on edges alone.
// A missing edge is the zero vector, and its terms vanish.
#ifndef MORPHGRID_ENERGY_EDGE
#define MORPHGRID_ENERGY_EDGE
#include "shared/energy_constants.h"
#include "energy/arm.glsl"

struct Edge {
  Arm arm;
  Squared square;    // |e|^2
  float halfSquare;  // |e|^2 / 2, but never 0: what divides.
  vec3 change;       // Change of the arm under a motion z, for products of a Hessian with z.
  float along;       // arm . change
};

Edge edgeOf(Arm arm, vec3 change) {
  Squared square = dot(arm, arm);
  float halfSquare = 0.5 * max(float(square), kLeastSquare);
  return Edge(arm, square, halfSquare, change, dot(vec3(arm), change));
}

Edge edgeBetween(ivec4 from, ivec4 to, float resolution) {
  return edgeOf(armBetween(from, to, resolution), vec3(0));
}

// factors.x times the edge, and factors.y times its change.
vec3 scaled(Edge e, vec2 factors) { return factors.x * vec3(e.arm) + factors.y * e.change; }
#endif
