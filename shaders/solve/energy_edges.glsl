// How columns.glsl sees vertices, edges, struts and corners where their energy and its gradient are
// wanted. Needs GRID and Sum.
// Differences of positions cancel: near equilibrium their rounding in single precision, and nothing
// else, sets the smallest residual. With PRECISE they and their dot products are doubles.
#include "solve/edge.glsl"
#include "solve/corner.glsl"

#define Vertex ivec4

struct Pull {
  float perEdge;
  Squared energy;
};

const Edge kNoEdge = Edge(Arm(0), Squared(0), 0.0);
const Pull kNoPull = Pull(0.0, Squared(0));

#define Own float
#include "solve/columns.glsl"

Vertex vertexAt(int index) { return imageLoad(positions, index); }

Edge edgeBetween(Vertex from, Vertex to) { return edgeBetween(from, to, GRID.resolution); }

Corner cornerOf(Edge a, Edge b) { return projectCorner(a, b); }

vec3 othersOf(Corner corner, Edge other) { return corner.other * vec3(other.arm); }

// The gradient per edge: 2 w c (1 - L / |e|).
Pull pullOf(Edge e, int rest, float stiffness) {
  float stretch = relativeStretch(e, rest, GRID.restResolution);
  return Pull(2.0 * stiffness * stretch,
              stiffness * squaredExcess(e, rest, GRID.restResolution));
}

vec3 edgeGradient(Edge e, Pull pull, Turn turn) {
  return (pull.perEdge + GRID.angleWeight * turn.own) * vec3(e.arm) +
         GRID.angleWeight * turn.others;
}
