// A walk through the layers of a block of columns: what one invocation of a kernel does that needs the
// energy's gradient, or a product of its Hessian, at every vertex. All terms of the energy depend on edges
// alone: what they add to an edge of the block is summed up, each stencil computed once, and a vertex takes
// the difference of the edges that end at it and those that leave it.
// A kernel includes this after it has defined
//   GRID               where its GridPush is
//   DAMPING            weight of every edge in a Laplacian that is added to a Hessian
//   Sum                the type in which energies are added up
//   kBlockU, kBlockV   columns of a block
//   kMeasure           whether energies are wanted
//   kDerivative        what is added up, see energy/derivative.glsl
// and defines the functions that are declared below.
// Loops are unrolled and nothing branches: lavapipe runs both sides of a branch, and keeps what a loop
// carries in masked memory. They count upwards between constants; of others compilers lose count, and
// leave these arrays in memory.
#extension GL_EXT_control_flow_attributes : require
#if !defined(GRID) || !defined(DAMPING) || !defined(Sum)
#error define GRID, DAMPING and Sum before the walk
#endif
#include "energy/strut.glsl"
#include "shared/topology.h"
#include "solve/printed_corners.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;  // A part of a row of blocks.
layout(constant_id = kConstantLayers) const int kLayers = 0;
layout(constant_id = kConstantUniformStiffness) const bool kUniformStiffness = false;

// Images, although nothing is stored through them: lavapipe inlines their loads, but calls a function
// for texelFetch.
layout(binding = kBindingPositions, rgba32i) readonly uniform iimageBuffer positions;
layout(binding = kBindingRest, rgba32i) readonly uniform iimageBuffer restLengths;
layout(binding = kBindingStiffness, rgba32f) readonly uniform imageBuffer stiffnesses;

struct Vertex {
  ivec4 position;
  vec3 motion;  // z of products, else 0.
};

Vertex vertexAt(int index);
// The vertex's gradient is complete; what is not `owned` must not be stored.
void finish(int index, bool owned, Vertex vertex, vec3 gradient, float stepPerForce);

// What the terms add to the gradient with respect to an edge, with their weights: any vector, or factors of
// the edge and of its change (energy/edge.glsl), which are cheaper.
struct EdgeSum {
  vec2 factors;
  vec3 gradient;
};

// A vertex until its gradient is complete.
struct VertexSum {
  Vertex vertex;
  vec3 gradient;
  float stepPerForce;
};

const EdgeSum kNoSum = EdgeSum(vec2(0), vec3(0));

// The block's columns are [1..kBlockV][1..kBlockU] of a ring that holds their neighbours too.
const int kRingU = kBlockU + 2;
const int kRingV = kBlockV + 2;
#define FOR_RANGE(v, firstV, lastV, u, firstU, lastU)     \
  [[unroll]] for (int v = (firstV); v <= (lastV); ++v)    \
      [[unroll]] for (int u = (firstU); u <= (lastU); ++u)
#define FOR_RING(v, u) FOR_RANGE(v, 0, kBlockV + 1, u, 0, kBlockU + 1)
#define FOR_BLOCK(v, u) FOR_RANGE(v, 1, kBlockV, u, 1, kBlockU)
// The edges to +u, and to +v, that begin or end in the block.
#define FOR_EAST(v, u) FOR_RANGE(v, 1, kBlockV, u, 0, kBlockU)
#define FOR_NORTH(v, u) FOR_RANGE(v, 0, kBlockV, u, 1, kBlockU)
// The cells around the block's columns; they are called as the vertex with the lowest indices.
#define FOR_CELLS(v, u) FOR_RANGE(v, 0, kBlockV, u, 0, kBlockU)

// Whether there may be vertical edges, as far as is known when the kernel is compiled.
bool mayHaveUp, mayHaveDown;
int ringIndex[kRingV][kRingU];  // of the bottom layer's vertices
bool owned[kRingV][kRingU];     // whether the column exists, is the block's, and may be stored

// The layer at hand; [v][u] is the vertex that an edge leaves.
Vertex here[kRingV][kRingU], above[kRingV][kRingU];
Edge east[kRingV][kRingU], north[kRingV][kRingU], up[kRingV][kRingU], down[kRingV][kRingU];
EdgeSum eastSum[kRingV][kRingU], northSum[kRingV][kRingU];
EdgeSum upSum[kRingV][kRingU], downSum[kRingV][kRingU];
vec4 directions[kRingV][kRingU];  // As printed, see kBindingPrinted.
ivec4 rest[kRingV][kRingU];
vec3 stiffness[kRingV][kRingU];
VertexSum vertexSum[kRingV][kRingU], vertexSumBelow[kRingV][kRingU];

Sum energy = Sum(0);  // of the block's own struts and apexes

// Beyond the border a neighbour is the vertex itself, its edge the zero vector.
void findRing(bool mayStore) {
  ivec2 first = ivec2(gl_GlobalInvocationID.xy) * ivec2(kBlockU, kBlockV) - 1;
  FOR_RING(v, u) {
    ivec2 column = first + ivec2(u, v);
    ringIndex[v][u] = pointIndex(ivec2(GRID.size), nearestPoint(ivec2(GRID.size), column));
    owned[v][u] = false;
  }
  FOR_BLOCK(v, u) { owned[v][u] = mayStore && hasColumn(GRID.size, first + ivec2(u, v)); }
}

Edge edgeBetween(Vertex from, Vertex to) {
  vec3 change = kDerivative == kGradient ? vec3(0) : to.motion - from.motion;
  return edgeOf(armBetween(from.position, to.position, GRID.resolution), change);
}

void layEdges() {
  FOR_RANGE(v, 0, kBlockV + 1, u, 0, kBlockU) {
    east[v][u] = edgeBetween(here[v][u], here[v][u + 1]);
    eastSum[v][u] = kNoSum;
  }
  FOR_RANGE(v, 0, kBlockV, u, 0, kBlockU + 1) {
    north[v][u] = edgeBetween(here[v][u], here[v + 1][u]);
    northSum[v][u] = kNoSum;
  }
  FOR_RING(v, u) {
    up[v][u] = edgeBetween(here[v][u], above[v][u]);
    upSum[v][u] = kNoSum;
  }
}

void addEnergy(bool counted, Squared term) {
  if (kMeasure) {
    energy += counted ? Sum(term) : Sum(0);
  }
}

void addCorner(bool counted, float weight, vec2 restAngle, Edge a, Edge b, inout EdgeSum sumOfA,
               inout EdgeSum sumOfB) {
  CornerGradient corner = cornerTerm(kDerivative, a, b, restAngle);
  vec2 coupling = weight * corner.coupling;
  sumOfA.factors += weight * corner.ofA;
  sumOfB.factors += weight * corner.ofB;
  sumOfA.gradient += scaled(b, coupling);
  sumOfB.gradient += scaled(a, coupling);
  addEnergy(counted, weight * corner.energy);
}

// Of the edge to +u at [eastV][eastU] with that to +v at [northV][northU].
void addLateralCorner(bool counted, int eastV, int eastU, int northV, int northU) {
  vec2 restAngle = kPrintedCorners ? restAngleBetween(directions[eastV][eastU].xy,
                                                      directions[northV][northU].zw)
                                   : kRightAngle;
  addCorner(counted, GRID.angleWeight, restAngle, east[eastV][eastU], north[northV][northU],
            eastSum[eastV][eastU], northSum[northV][northU]);
}

// The corners of a cell in the layer: four edges, an apex at each end.
void addCellCorners(int v, int u) {
  addLateralCorner(owned[v][u], v, u, v, u);
  addLateralCorner(owned[v][u + 1], v, u, v, u + 1);
  addLateralCorner(owned[v + 1][u], v + 1, u, v, u);
  addLateralCorner(owned[v + 1][u + 1], v + 1, u, v, u + 1);
}

// The corners of a lateral edge with the vertical ones at [v][u].
void addUprightCorners(int v, int u, Edge lateral, inout EdgeSum sum) {
  if (mayHaveUp) {
    addCorner(owned[v][u], GRID.postAngleWeight, kRightAngle, lateral, up[v][u], sum, upSum[v][u]);
  }
  if (mayHaveDown) {
    addCorner(owned[v][u], GRID.postAngleWeight, kRightAngle, lateral, down[v][u], sum,
              downSum[v][u]);
  }
}

// What they add to edges outside of the block is never read: compilers drop it.
void addCorners() {
  FOR_CELLS(v, u) { addCellCorners(v, u); }
  FOR_EAST(v, u) {
    addUprightCorners(v, u, east[v][u], eastSum[v][u]);
    addUprightCorners(v, u + 1, east[v][u], eastSum[v][u]);
  }
  FOR_NORTH(v, u) {
    addUprightCorners(v, u, north[v][u], northSum[v][u]);
    addUprightCorners(v + 1, u, north[v][u], northSum[v][u]);
  }
}

void addStrut(bool counted, Edge e, int rest, float stiffness, inout EdgeSum sum) {
  StrutGradient strut = strutTerm(kDerivative, e, Spring(rest, GRID.restResolution, stiffness));
  sum.factors += strut.diagonal;
  addEnergy(counted, strut.energy);
}

vec3 stiffnessAt(int index) {
  return kUniformStiffness
             ? vec3(GRID.lateralStiffness, GRID.lateralStiffness, GRID.verticalStiffness)
             : imageLoad(stiffnesses, index).xyz;
}

void addStruts(int start) {
  FOR_CELLS(v, u) {
    rest[v][u] = imageLoad(restLengths, start + ringIndex[v][u]);
    stiffness[v][u] = stiffnessAt(start + ringIndex[v][u]);
  }
  FOR_EAST(v, u) {
    addStrut(owned[v][u], east[v][u], rest[v][u].x, stiffness[v][u].x, eastSum[v][u]);
  }
  FOR_NORTH(v, u) {
    addStrut(owned[v][u], north[v][u], rest[v][u].y, stiffness[v][u].y, northSum[v][u]);
  }
  FOR_BLOCK(v, u) {
    addStrut(owned[v][u], up[v][u], rest[v][u].z, stiffness[v][u].z, upSum[v][u]);
  }
}

void loadDirections(int start) {
  if (kPrintedCorners) {
    FOR_RING(v, u) { directions[v][u] = imageLoad(printed, start + ringIndex[v][u]); }
  }
}

// The gradient with respect to an edge, at its ends.
void addToEnds(Edge e, EdgeSum sum, inout VertexSum from, inout VertexSum to) {
  vec3 gradient = scaled(e, sum.factors + vec2(0, DAMPING)) + sum.gradient;
  from.gradient -= gradient;
  to.gradient += gradient;
}

// Vertical edges wait for the corners of the layer above.
void addLayer(int start) {
  layEdges();
  loadDirections(start);
  addCorners();
  addStruts(start);
  FOR_RING(v, u) { vertexSum[v][u] = VertexSum(here[v][u], vec3(0), 0.0); }
  FOR_BLOCK(v, u) { vertexSum[v][u].stepPerForce = intBitsToFloat(rest[v][u].w); }
  FOR_EAST(v, u) {
    addToEnds(east[v][u], eastSum[v][u], vertexSum[v][u], vertexSum[v][u + 1]);
  }
  FOR_NORTH(v, u) {
    addToEnds(north[v][u], northSum[v][u], vertexSum[v][u], vertexSum[v + 1][u]);
  }
}

void finishSum(int index, bool mayStore, VertexSum sum) {
  finish(index, mayStore, sum.vertex, sum.gradient, sum.stepPerForce);
}

// The layer below is complete once the corners of this one have been added to the edges between them.
void finishBelow(int startOfLayerBelow) {
  FOR_BLOCK(v, u) {
    addToEnds(down[v][u], downSum[v][u], vertexSumBelow[v][u], vertexSum[v][u]);
    finishSum(startOfLayerBelow + ringIndex[v][u], owned[v][u], vertexSumBelow[v][u]);
  }
}

void finishTop(int start) {
  FOR_BLOCK(v, u) { finishSum(start + ringIndex[v][u], owned[v][u], vertexSum[v][u]); }
}

void goUp() {
  here = above;
  down = up;
  downSum = upSum;
  vertexSumBelow = vertexSum;
}

void walkColumns() {
  int layers = kLayers > 0 ? kLayers : GRID.size.z;
  int layerLength = GRID.size.x * GRID.size.y;
  FOR_RING(v, u) {
    here[v][u] = vertexAt(ringIndex[v][u]);
    down[v][u] = edgeOf(Arm(0), vec3(0));
    downSum[v][u] = kNoSum;
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
    addLayer(start);
    if (layer > 0) {
      finishBelow(start - layerLength);
    }
    if (isTop) {
      finishTop(start);
    }
    goUp();
  }
}
