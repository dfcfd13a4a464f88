// One sweep of Jacobi-style projective dynamics with Chebyshev acceleration: every strut and corner is
// projected, every vertex takes the weighted mean of what its constraints want.
// One invocation walks the layers of a block of columns. Struts and corners depend on edges alone: their
// gradients with respect to the block's edges are added up, and a vertex takes the difference of those
// that end at it and those that leave it.
// Differences of positions cancel: near equilibrium their rounding in single precision, and nothing
// else, sets the smallest residual. With PRECISE they and their dot products are doubles.
// Loops are unrolled and nothing branches: lavapipe runs both sides of a branch, and keeps what a loop
// carries in masked memory. They count upwards between constants; of others compilers lose count, and
// leave these arrays in memory.
#extension GL_EXT_control_flow_attributes : require
#include "shared/solver_types.h"
#include "solve/arm.glsl"
#include "solve/corner.glsl"

layout(local_size_x_id = 0) in;  // A subgroup: a part of a row of blocks.
layout(constant_id = 1) const bool kMeasure = false;
layout(constant_id = 2) const int kLayers = 0;  // 0: known at run time only; works for any number.
layout(constant_id = 3) const bool kUniformStiffness = false;

// Images, although nothing is stored through them: lavapipe inlines their loads, but calls a function
// for texelFetch.
layout(binding = kBindingPositions, rgba32i) readonly uniform iimageBuffer positions;
layout(binding = kBindingRest, rgba32i) readonly uniform iimageBuffer restLengths;
layout(binding = kBindingStiffness, rgba32f) readonly uniform imageBuffer stiffnesses;
// One buffer twice, as loads of texels are the faster ones. A vertex's entry is loaded, then stored, by
// the one invocation that moves the vertex.
layout(binding = kBindingPreviousPositions, rgba32i) readonly uniform iimageBuffer previous;
layout(std430, binding = kBindingNextPositions) writeonly buffer NextPositions { ivec4 next[]; };
layout(std430, binding = kBindingState) readonly buffer State { SolverState state; };
layout(std430, binding = kBindingPartials) writeonly buffer Partials { vec4 partials[]; };
layout(push_constant) uniform Push { SweepPush push; };

shared vec4 sums[kLargestSubgroup];

// Spacings that a vertex may move in one sweep; keeps a wild start within the fixed-point range.
const float kLargestMove = 1.0;
const float kRelaxation = 0.9;

// The block's columns are [1..kBlockV][1..kBlockU] of a ring that holds their neighbours too.
const int kRingU = kBlockU + 2;
const int kRingV = kBlockV + 2;
#define FOR_RING(v, u) \
  [[unroll]] for (int v = 0; v < kRingV; ++v) [[unroll]] for (int u = 0; u < kRingU; ++u)
#define FOR_BLOCK(v, u) \
  [[unroll]] for (int v = 1; v <= kBlockV; ++v) [[unroll]] for (int u = 1; u <= kBlockU; ++u)

// Gradient of the corners with respect to an edge: per angle weight, own edge + others.
struct Turn {
  float own;
  vec3 others;
};
const Turn kNoTurn = Turn(0.0, vec3(0));

// What a vertex needs of its own until its gradient is complete.
struct Mover {
  ivec4 position;
  vec3 gradient;
  float stepPerForce;
};

// Whether there may be vertical edges, as far as is known when the kernel is compiled; missing ones are
// zero vectors.
bool mayHaveUp, mayHaveDown;
int ringIndex[kRingV][kRingU];  // of the bottom layer's vertices
bool owned[kRingV][kRingU];     // whether the block's vertex is there, and may move
float momentum;

// The layer at hand; [v][u] is the vertex that an edge leaves.
ivec4 here[kRingV][kRingU], above[kRingV][kRingU];
Edge east[kRingV][kRingU], north[kRingV][kRingU], up[kRingV][kRingU], down[kRingV][kRingU];
Turn eastTurn[kRingV][kRingU], northTurn[kRingV][kRingU];
Turn upTurn[kRingV][kRingU], downTurn[kRingV][kRingU];
float upPull[kRingV][kRingU], downPull[kRingV][kRingU];  // of the struts, per edge
Mover movers[kRingV][kRingU], moversBelow[kRingV][kRingU];

float energy = 0.0;  // of the block's own struts and apexes
float squaredGradient = 0.0;
float gradientAlongVelocity = 0.0;

Edge edge(ivec4 from, ivec4 to) { return edgeBetween(from, to, push.resolution); }

// Beyond the border a neighbour is the vertex itself, its edge the zero vector.
void findRing() {
  ivec2 first = ivec2(gl_GlobalInvocationID.xy) * ivec2(kBlockU, kBlockV) - 1;
  ivec2 size = ivec2(push.verticesU, push.verticesV);
  FOR_RING(v, u) {
    ivec2 column = first + ivec2(u, v);
    ivec2 nearest = clamp(column, ivec2(0), size - 1);
    ringIndex[v][u] = nearest.y * push.verticesU + nearest.x;
    owned[v][u] = state.done == 0u && column == nearest;
  }
}

// Chebyshev semi-iteration whose assumed condition grows with the sweeps since the last restart.
float chebyshevMomentum() {
  float sweeps = float(state.sweepsSinceRestart + push.sweep);
  float root = sweeps / (sweeps + 2.0);
  return root * root;
}

void layEdges() {
  FOR_RING(v, u) {
    if (u + 1 < kRingU) {
      east[v][u] = edge(here[v][u], here[v][u + 1]);
    }
    if (v + 1 < kRingV) {
      north[v][u] = edge(here[v][u], here[v + 1][u]);
    }
    up[v][u] = edge(here[v][u], above[v][u]);
    eastTurn[v][u] = northTurn[v][u] = upTurn[v][u] = kNoTurn;
  }
}

// A corner at a vertex of the block: both its edges are the block's.
void turnBoth(bool counted, Edge a, Edge b, inout Turn turnOfA, inout Turn turnOfB) {
  Corner corner = projectCorner(a, b);
  turnOfA.own += corner.own;
  turnOfB.own += corner.own;
  turnOfA.others += corner.other * vec3(b.arm);
  turnOfB.others += corner.other * vec3(a.arm);
  if (kMeasure) {
    energy += counted ? push.angleWeight * corner.energy : 0.0;
  }
}

// A corner at a neighbour of the block: only the edge a leads to the block.
void turnOne(Edge a, Edge b, inout Turn turnOfA) {
  Corner corner = projectCorner(a, b);
  turnOfA.own += corner.own;
  turnOfA.others += corner.other * vec3(b.arm);
}

void turnWithin() {
  FOR_BLOCK(v, u) {
    bool counted = owned[v][u];
    [[unroll]] for (int side = 0; side < 2; ++side) {
      int w = u - side;  // the edge to the east, then to the west
      int s = v - side;
      turnBoth(counted, east[v][w], north[v - 1][u], eastTurn[v][w], northTurn[v - 1][u]);
      turnBoth(counted, east[v][w], north[v][u], eastTurn[v][w], northTurn[v][u]);
      if (mayHaveUp) {
        turnBoth(counted, east[v][w], up[v][u], eastTurn[v][w], upTurn[v][u]);
        turnBoth(counted, north[s][u], up[v][u], northTurn[s][u], upTurn[v][u]);
      }
      if (mayHaveDown) {
        turnBoth(counted, east[v][w], down[v][u], eastTurn[v][w], downTurn[v][u]);
        turnBoth(counted, north[s][u], down[v][u], northTurn[s][u], downTurn[v][u]);
      }
    }
  }
}

// The corners at an apex outside of the block; `a` leads from there to the block.
void turnOutside(ivec2 apex, Edge a, Edge before, Edge after, inout Turn turn) {
  turnOne(a, before, turn);
  turnOne(a, after, turn);
  if (mayHaveUp) {
    turnOne(a, up[apex.y][apex.x], turn);
  }
  if (mayHaveDown) {
    turnOne(a, down[apex.y][apex.x], turn);
  }
}

void turnAround() {
  [[unroll]] for (int side = 0; side < 2; ++side) {
    int apexU = side * (kRingU - 1), edgeU = side * kBlockU;
    [[unroll]] for (int v = 1; v <= kBlockV; ++v) {
      turnOutside(ivec2(apexU, v), east[v][edgeU], north[v - 1][apexU], north[v][apexU],
                  eastTurn[v][edgeU]);
    }
    int apexV = side * (kRingV - 1), edgeV = side * kBlockV;
    [[unroll]] for (int u = 1; u <= kBlockU; ++u) {
      turnOutside(ivec2(u, apexV), north[edgeV][u], east[apexV][u - 1], east[apexV][u],
                  northTurn[edgeV][u]);
    }
  }
}

// The strut's gradient per edge: 2 w c (1 - L / |e|).
float strutPull(bool counted, Edge e, int rest, float stiffness) {
  float stretch = relativeStretch(e, rest, push.restResolution);
  if (kMeasure) {
    energy += counted ? stiffness * stretch * stretch * float(e.square) : 0.0;
  }
  return 2.0 * stiffness * stretch;
}

vec3 edgeGradient(Edge e, float pull, Turn turn) {
  return (pull + push.angleWeight * turn.own) * vec3(e.arm) + push.angleWeight * turn.others;
}

vec3 stiffnessAt(int index) {
  return kUniformStiffness
             ? vec3(push.lateralStiffness, push.lateralStiffness, push.verticalStiffness)
             : imageLoad(stiffnesses, index).xyz;
}

// The edge east of [v][u] pulls both its ends.
void pullEast(int v, int u, bool counted, int rest, float stiffness) {
  float pull = strutPull(counted, east[v][u], rest, stiffness);
  vec3 gradient = edgeGradient(east[v][u], pull, eastTurn[v][u]);
  movers[v][u].gradient -= gradient;
  movers[v][u + 1].gradient += gradient;
}

void pullNorth(int v, int u, bool counted, int rest, float stiffness) {
  float pull = strutPull(counted, north[v][u], rest, stiffness);
  vec3 gradient = edgeGradient(north[v][u], pull, northTurn[v][u]);
  movers[v][u].gradient -= gradient;
  movers[v + 1][u].gradient += gradient;
}

// Vertical edges wait for the corners of the layer above.
void pullLayer(int start) {
  FOR_RING(v, u) { movers[v][u] = Mover(here[v][u], vec3(0), 0.0); }
  FOR_BLOCK(v, u) {
    ivec4 rest = imageLoad(restLengths, start + ringIndex[v][u]);
    vec3 stiffness = stiffnessAt(start + ringIndex[v][u]);
    movers[v][u].stepPerForce = intBitsToFloat(rest.w);
    pullEast(v, u, owned[v][u], rest.x, stiffness.x);
    pullNorth(v, u, owned[v][u], rest.y, stiffness.y);
    upPull[v][u] = strutPull(owned[v][u], up[v][u], rest.z, stiffness.z);
  }
  [[unroll]] for (int v = 1; v <= kBlockV; ++v) {
    int west = start + ringIndex[v][0];
    pullEast(v, 0, false, imageLoad(restLengths, west).x, stiffnessAt(west).x);
  }
  [[unroll]] for (int u = 1; u <= kBlockU; ++u) {
    int south = start + ringIndex[0][u];
    pullNorth(0, u, false, imageLoad(restLengths, south).y, stiffnessAt(south).y);
  }
}

void move(int index, bool allowed, Mover mover) {
  vec3 velocity = stepsBetween(imageLoad(previous, index), mover.position);
  vec3 jump =
      -(1.0 + momentum) * kRelaxation * mover.stepPerForce / push.resolution * mover.gradient;
  float largest = kLargestMove / push.resolution;
  ivec4 position =
      moved(mover.position, clamp(momentum * velocity + jump, -largest, largest));
  if (allowed) {
    next[index] = position;
  }
  if (kMeasure && allowed) {
    squaredGradient += dot(mover.gradient, mover.gradient);
    gradientAlongVelocity += dot(mover.gradient, velocity) * push.resolution;
  }
}

// The layer below is complete once the corners of this one have turned the edges between them.
void moveBelow(int startOfLayerBelow) {
  FOR_BLOCK(v, u) {
    vec3 gradient = edgeGradient(down[v][u], downPull[v][u], downTurn[v][u]);
    moversBelow[v][u].gradient -= gradient;
    movers[v][u].gradient += gradient;
    move(startOfLayerBelow + ringIndex[v][u], owned[v][u], moversBelow[v][u]);
  }
}

void moveTop(int layerStart) {
  FOR_BLOCK(v, u) { move(layerStart + ringIndex[v][u], owned[v][u], movers[v][u]); }
}

void goUp() {
  here = above;
  down = up;
  downTurn = upTurn;
  downPull = upPull;
  moversBelow = movers;
}

void sweepColumns() {
  int layers = kLayers > 0 ? kLayers : push.layers;
  int layerLength = push.verticesU * push.verticesV;
  FOR_RING(v, u) {
    here[v][u] = imageLoad(positions, ringIndex[v][u]);
    down[v][u] = Edge(Arm(0), Squared(0), 0.0);
    downTurn[v][u] = kNoTurn;
    downPull[v][u] = 0.0;
  }
  [[unroll]] for (int layer = 0; layer < layers; ++layer) {
    int start = layer * layerLength;
    bool isTop = layer + 1 == layers;
    mayHaveUp = kLayers == 0 || !isTop;
    mayHaveDown = kLayers == 0 || layer > 0;
    int startAbove = isTop ? start : start + layerLength;
    FOR_RING(v, u) {
      above[v][u] =
          mayHaveUp ? imageLoad(positions, startAbove + ringIndex[v][u]) : here[v][u];
    }
    layEdges();
    turnWithin();
    turnAround();
    pullLayer(start);
    if (layer > 0) {
      moveBelow(start - layerLength);
    }
    if (isTop) {
      moveTop(start);
    }
    goUp();
  }
}

// Pairwise sums over the workgroup: accurate and the same in every run.
void writePartials() {
  uint lane = gl_LocalInvocationIndex;
  sums[lane] = vec4(energy, squaredGradient, gradientAlongVelocity, 0.0);
  for (uint stride = gl_WorkGroupSize.x / 2u; stride > 0u; stride /= 2u) {
    barrier();
    if (lane < stride) {
      sums[lane] += sums[lane + stride];
    }
  }
  if (lane == 0u) {
    partials[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = sums[0];
  }
}

void main() {
  findRing();
  momentum = chebyshevMomentum();
  sweepColumns();
  if (kMeasure) {
    writePartials();
  }
}
