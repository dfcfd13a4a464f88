// The Gauss-Newton Hessian H at `positions`, applied to a vector z without ever being stored. An
// including kernel defines finish(), which gets a vertex's part of H z as its gradient.
#include "shared/hessian_types.h"
#include "solve/arm.glsl"
#include "solve/corner_derivative.glsl"

const int kBlockU = int(kSweepBlockU);
const int kBlockV = int(kHessianBlockV);
const bool kMeasure = false;

layout(binding = kBindingVector, rgba32f) readonly uniform imageBuffer vectors;
layout(std430, binding = kBindingResult) writeonly buffer Result { vec4 result[]; };
layout(push_constant) uniform Push { HessianPush push; };

struct Vertex {
  ivec4 position;
  vec3 z;
};

struct Edge {
  vec3 arm;
  float halfSquare;
  vec3 change;  // of z along the edge
  float along;  // arm . change
};

struct Corner {
  float own;
  float other;
  float energy;
};

// The strut's gradient is perEdge edge + perChange change.
struct Pull {
  float perEdge;
  float perChange;
  float energy;
};

// Added to halves of squares: a missing edge, and two that meet, must not divide by zero.
const float kNoLength = 1e-10;
const Edge kNoEdge = Edge(vec3(0), kNoLength, vec3(0), 0.0);
const Pull kNoPull = Pull(0.0, 0.0, 0.0);

#define GRID push.grid
#define Sum float
#include "solve/columns.glsl"

Vertex vertexAt(int index) {
  return Vertex(imageLoad(positions, index), imageLoad(vectors, index).xyz);
}

Edge edgeBetween(Vertex from, Vertex to) {
  vec3 arm = armBetween(from.position, to.position, GRID.resolution);
  vec3 change = to.z - from.z;
  return Edge(arm, 0.5 * dot(arm, arm) + kNoLength, change, dot(arm, change));
}

// 2 J^T J z with respect to a is own a + other b.
Corner cornerOf(Edge a, Edge b) {
  CornerDerivative d = differentiateCorner(a.arm, b.arm, a.halfSquare, b.halfSquare);
  float share = d.s / d.h;
  float across = dot(a.arm, b.change) + dot(b.arm, a.change);
  float other = (across - share * (a.along + b.along)) * d.h / d.doubleSquare;
  return Corner(-share * other, other, 0.0);
}

// 2 c (n n^T + k (I - n n^T)) with k = max(0, 1 - L / l): what compression would subtract is left out,
// so that H is positive semidefinite.
Pull pullOf(Edge e, int rest, float stiffness) {
  float inverseLength = inversesqrt(2.0 * e.halfSquare);
  float stretch = max(0.0, 1.0 - float(rest) * GRID.restResolution * inverseLength);
  float perEdge = 2.0 * stiffness * (1.0 - stretch) * inverseLength * inverseLength * e.along;
  return Pull(perEdge, 2.0 * stiffness * stretch + push.damping, 0.0);
}

vec3 edgeGradient(Edge e, Pull pull, Turn turn) {
  return (pull.perEdge + GRID.angleWeight * turn.own) * e.arm + pull.perChange * e.change +
         GRID.angleWeight * turn.others;
}

void main() {
  findRing(true);
  walkColumns();
}
