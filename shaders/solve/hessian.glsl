// The Gauss-Newton Hessian H at `positions`, applied to a vector z without ever being stored; with
// EXACT the Hessian itself, which may be indefinite. An including kernel defines finish(), which gets a
// vertex's part of H z as its gradient.
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

#ifdef EXACT
#define Own vec2  // times the edge, and times its change
#else
#define Own float
#endif

struct Corner {
  Own own;
  Own other;
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

#ifdef EXACT
// The change of the gradient own a + other b (corner.glsl): with r = 1 / sqrt(t^2 - s^2) and
// m = r^3 (t s' - s t'), own' = -s m and other' = t m.
Corner cornerOf(Edge a, Edge b) {
  float s = dot(a.arm, b.arm);
  float t = a.halfSquare + b.halfSquare;
  float r = inversesqrt(abs((t - s) * (t + s)) + kLeastSine2 * t * t);
  float other = s * r;
  float own = -other * other / (1.0 + t * r);
  float across = dot(a.arm, b.change) + dot(b.arm, a.change);
  float m = r * r * r * (t * across - s * (a.along + b.along));
  return Corner(vec2(-s * m, own), vec2(t * m, other), 0.0);
}

vec3 othersOf(Corner corner, Edge other) {
  return corner.other.x * other.arm + corner.other.y * other.change;
}
#else
// 2 J^T J z with respect to a is own a + other b.
Corner cornerOf(Edge a, Edge b) {
  CornerDerivative d = differentiateCorner(a.arm, b.arm, a.halfSquare, b.halfSquare);
  float share = d.s / d.h;
  float across = dot(a.arm, b.change) + dot(b.arm, a.change);
  float other = (across - share * (a.along + b.along)) * d.h / d.doubleSquare;
  return Corner(-share * other, other, 0.0);
}

vec3 othersOf(Corner corner, Edge other) { return corner.other * other.arm; }
#endif

// 2 c (n n^T + k (I - n n^T)) with k = 1 - L / l. Gauss-Newton leaves out what compression would
// subtract, so that H is positive semidefinite.
Pull pullOf(Edge e, int rest, float stiffness) {
  float inverseLength = inversesqrt(2.0 * e.halfSquare);
  float stretch = 1.0 - float(rest) * GRID.restResolution * inverseLength;
#ifndef EXACT
  stretch = max(0.0, stretch);
#endif
  float perEdge = 2.0 * stiffness * (1.0 - stretch) * inverseLength * inverseLength * e.along;
  return Pull(perEdge, 2.0 * stiffness * stretch + push.damping, 0.0);
}

vec3 edgeGradient(Edge e, Pull pull, Turn turn) {
#ifdef EXACT
  float perChange = pull.perChange + GRID.angleWeight * turn.own.y;
  float turnOfEdge = turn.own.x;
#else
  float perChange = pull.perChange;
  float turnOfEdge = turn.own;
#endif
  return (pull.perEdge + GRID.angleWeight * turnOfEdge) * e.arm + perChange * e.change +
         GRID.angleWeight * turn.others;
}

void main() {
  findRing(true);
  walkColumns();
}
