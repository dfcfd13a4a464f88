// A walk through the layers of a block of columns: what one invocation of a kernel does that needs the
// forces of struts and corners at every vertex. Both depend on edges alone: their gradients with respect
// to the block's edges are added up, each corner projected once, and a vertex takes the difference of
// the edges that end at it and those that leave it.
// A kernel includes this after it has defined
//   kBlockU, kBlockV   columns of a block
//   kMeasure           whether energies are wanted, added up in a Sum
//   GRID               where its GridPush is
//   Vertex, Edge       what is known of a vertex and of an edge; kNoEdge: the zero vector
//   Own                float, or a vector: what corners do to their edges that is the edges' own
//   Corner             own, other, energy: what it does to its edges, per angle weight
//   Pull               what a strut does to its edge, with its energy; kNoPull: nothing
// and defines the functions that are declared below.
// Loops are unrolled and nothing branches: lavapipe runs both sides of a branch, and keeps what a loop
// carries in masked memory. They count upwards between constants; of others compilers lose count, and
// leave these arrays in memory.
#extension GL_EXT_control_flow_attributes : require
#include "shared/topology.h"

layout(local_size_x_id = 0) in;  // A subgroup: a part of a row of blocks.
layout(constant_id = 1) const int kLayers = 0;  // 0: known at run time only; works for any number.
layout(constant_id = 2) const bool kUniformStiffness = false;

// Images, although nothing is stored through them: lavapipe inlines their loads, but calls a function
// for texelFetch.
layout(binding = kBindingPositions, rgba32i) readonly uniform iimageBuffer positions;
layout(binding = kBindingRest, rgba32i) readonly uniform iimageBuffer restLengths;
layout(binding = kBindingStiffness, rgba32f) readonly uniform imageBuffer stiffnesses;

// Gradient of the corners with respect to an edge: per angle weight, what `own` makes of the edge and
// the others.
struct Turn {
  Own own;
  vec3 others;
};
const Turn kNoTurn = Turn(Own(0), vec3(0));

Vertex vertexAt(int index);
Edge edgeBetween(Vertex from, Vertex to);
Corner cornerOf(Edge a, Edge b);
// What a corner adds to the gradient with respect to the one edge because of the other.
vec3 othersOf(Corner corner, Edge other);
Pull pullOf(Edge e, int rest, float stiffness);
vec3 edgeGradient(Edge e, Pull pull, Turn turn);
// The vertex's gradient is complete; what is not `owned` must not be stored.
void finish(int index, bool owned, Vertex vertex, vec3 gradient, float stepPerForce);

// The block's columns are [1..kBlockV][1..kBlockU] of a ring that holds their neighbours too.
const int kRingU = kBlockU + 2;
const int kRingV = kBlockV + 2;
#define FOR_RING(v, u) \
  [[unroll]] for (int v = 0; v < kRingV; ++v) [[unroll]] for (int u = 0; u < kRingU; ++u)
#define FOR_BLOCK(v, u) \
  [[unroll]] for (int v = 1; v <= kBlockV; ++v) [[unroll]] for (int u = 1; u <= kBlockU; ++u)

// What a vertex needs of its own until its gradient is complete.
struct Pending {
  Vertex vertex;
  vec3 gradient;
  float stepPerForce;
};

// Whether there may be vertical edges, as far as is known when the kernel is compiled; missing ones are
// zero vectors.
bool mayHaveUp, mayHaveDown;
int ringIndex[kRingV][kRingU];  // of the bottom layer's vertices
bool owned[kRingV][kRingU];     // whether the column is in the grid, and its vertices may be stored

// The layer at hand; [v][u] is the vertex that an edge leaves.
Vertex here[kRingV][kRingU], above[kRingV][kRingU];
Edge east[kRingV][kRingU], north[kRingV][kRingU], up[kRingV][kRingU], down[kRingV][kRingU];
Turn eastTurn[kRingV][kRingU], northTurn[kRingV][kRingU];
Turn upTurn[kRingV][kRingU], downTurn[kRingV][kRingU];
Pull upPull[kRingV][kRingU], downPull[kRingV][kRingU];
Pending pending[kRingV][kRingU], pendingBelow[kRingV][kRingU];

Sum energy = Sum(0);  // of the block's own struts and apexes

// Beyond the border a neighbour is the vertex itself, its edge the zero vector.
void findRing(bool mayStore) {
  ivec2 first = ivec2(gl_GlobalInvocationID.xy) * ivec2(kBlockU, kBlockV) - 1;
  FOR_RING(v, u) {
    ivec2 column = first + ivec2(u, v);
    ringIndex[v][u] = pointIndex(ivec2(GRID.size), nearestPoint(ivec2(GRID.size), column));
    owned[v][u] = mayStore && hasColumn(GRID.size, column);
  }
}

void layEdges() {
  FOR_RING(v, u) {
    if (u + 1 < kRingU) {
      east[v][u] = edgeBetween(here[v][u], here[v][u + 1]);
    }
    if (v + 1 < kRingV) {
      north[v][u] = edgeBetween(here[v][u], here[v + 1][u]);
    }
    up[v][u] = edgeBetween(here[v][u], above[v][u]);
    eastTurn[v][u] = northTurn[v][u] = upTurn[v][u] = kNoTurn;
  }
}

// A corner at a vertex of the block: both its edges are the block's.
void turnBoth(bool counted, Edge a, Edge b, inout Turn turnOfA, inout Turn turnOfB) {
  Corner corner = cornerOf(a, b);
  turnOfA.own += corner.own;
  turnOfB.own += corner.own;
  turnOfA.others += othersOf(corner, b);
  turnOfB.others += othersOf(corner, a);
  if (kMeasure) {
    energy += counted ? Sum(GRID.angleWeight * corner.energy) : Sum(0);
  }
}

// A corner at a neighbour of the block: only the edge a leads to the block.
void turnOne(Edge a, Edge b, inout Turn turnOfA) {
  Corner corner = cornerOf(a, b);
  turnOfA.own += corner.own;
  turnOfA.others += othersOf(corner, b);
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

Pull strutPull(bool counted, Edge e, int rest, float stiffness) {
  Pull pull = pullOf(e, rest, stiffness);
  if (kMeasure) {
    energy += counted ? Sum(pull.energy) : Sum(0);
  }
  return pull;
}

vec3 stiffnessAt(int index) {
  return kUniformStiffness
             ? vec3(GRID.lateralStiffness, GRID.lateralStiffness, GRID.verticalStiffness)
             : imageLoad(stiffnesses, index).xyz;
}

// The edge east of [v][u] pulls both its ends.
void pullEast(int v, int u, bool counted, int rest, float stiffness) {
  Pull pull = strutPull(counted, east[v][u], rest, stiffness);
  vec3 gradient = edgeGradient(east[v][u], pull, eastTurn[v][u]);
  pending[v][u].gradient -= gradient;
  pending[v][u + 1].gradient += gradient;
}

void pullNorth(int v, int u, bool counted, int rest, float stiffness) {
  Pull pull = strutPull(counted, north[v][u], rest, stiffness);
  vec3 gradient = edgeGradient(north[v][u], pull, northTurn[v][u]);
  pending[v][u].gradient -= gradient;
  pending[v + 1][u].gradient += gradient;
}

// Vertical edges wait for the corners of the layer above.
void pullLayer(int start) {
  FOR_RING(v, u) { pending[v][u] = Pending(here[v][u], vec3(0), 0.0); }
  FOR_BLOCK(v, u) {
    ivec4 rest = imageLoad(restLengths, start + ringIndex[v][u]);
    vec3 stiffness = stiffnessAt(start + ringIndex[v][u]);
    pending[v][u].stepPerForce = intBitsToFloat(rest.w);
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

void finishPending(int index, bool mayStore, Pending p) {
  finish(index, mayStore, p.vertex, p.gradient, p.stepPerForce);
}

// The layer below is complete once the corners of this one have turned the edges between them.
void finishBelow(int startOfLayerBelow) {
  FOR_BLOCK(v, u) {
    vec3 gradient = edgeGradient(down[v][u], downPull[v][u], downTurn[v][u]);
    pendingBelow[v][u].gradient -= gradient;
    pending[v][u].gradient += gradient;
    finishPending(startOfLayerBelow + ringIndex[v][u], owned[v][u], pendingBelow[v][u]);
  }
}

void finishTop(int start) {
  FOR_BLOCK(v, u) { finishPending(start + ringIndex[v][u], owned[v][u], pending[v][u]); }
}

void goUp() {
  here = above;
  down = up;
  downTurn = upTurn;
  downPull = upPull;
  pendingBelow = pending;
}

void walkColumns() {
  int layers = kLayers > 0 ? kLayers : GRID.size.z;
  int layerLength = GRID.size.x * GRID.size.y;
  FOR_RING(v, u) {
    here[v][u] = vertexAt(ringIndex[v][u]);
    down[v][u] = kNoEdge;
    downTurn[v][u] = kNoTurn;
    downPull[v][u] = kNoPull;
  }
  [[unroll]] for (int layer = 0; layer < layers; ++layer) {
    int start = layer * layerLength;
    bool isTop = layer + 1 == layers;
    mayHaveUp = kLayers == 0 || !isTop;
    mayHaveDown = kLayers == 0 || layer > 0;
    int startAbove = isTop ? start : start + layerLength;
    FOR_RING(v, u) {
      above[v][u] = mayHaveUp ? vertexAt(startAbove + ringIndex[v][u]) : here[v][u];
    }
    layEdges();
    turnWithin();
    turnAround();
    pullLayer(start);
    if (layer > 0) {
      finishBelow(start - layerLength);
    }
    if (isTop) {
      finishTop(start);
    }
    goUp();
  }
}
