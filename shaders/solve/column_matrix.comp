// The columns' matrix P^T H P at the positions: five blocks of a column's row, gathered from its struts and
// corners. A face of the grid is four vertices in a ring with a corner at each. Round the column there are
// four lateral faces a layer and four vertical ones between layers. Runs once in several cycles: a corner
// is differentiated once for each of its columns.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "energy/strut.glsl"
#include "shared/multigrid_types.h"
#include "solve/block.glsl"
#include "solve/columns_of_points.glsl"
#include "solve/point_rows.glsl"
#include "solve/printed_corners.glsl"
#include "solve/store_stencil.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;

layout(binding = kBindingRest, rgba32i) readonly uniform iimageBuffer restLengths;
layout(binding = kBindingStiffness, rgba32f) readonly uniform imageBuffer stiffnesses;

struct Vertex {
  ivec4 position;
  vec3 lever;  // From the centre of its column.
};

// A corner's 2 w J^T J, J as rows of its vertices' columns.
struct Derivative {
  float weight;
  Motion apex, next, previous;
};

// The column, and its neighbours a and b a quarter turn apart, with d beyond both.
ivec2 p, a, b, d;
ivec4 centreP, centreA, centreB, centreD;
// The parts of the column's row in which the neighbours' motions are multiplied.
Block withP, withA, withB, withD;

Vertex vertexAt(ivec2 column, int layer, ivec4 centre) {
  ivec4 position = positionAt(column, layer);
  return Vertex(position, between(centre, position));
}

Motion rowOf(vec3 derivative, Vertex vertex) {
  return Motion(derivative, cross(vertex.lever, derivative));
}

// Neighbours in a ring: previous, apex, next.
Derivative differentiate(float weight, vec2 restAngle, Vertex previous, Vertex apex, Vertex next) {
  Edge toNext = edgeBetween(apex.position, next.position, push.grid.resolution);
  Edge toPrevious = edgeBetween(apex.position, previous.position, push.grid.resolution);
  CornerJacobian j = cornerJacobian(toNext, toPrevious, restAngle);
  vec3 ofNext = j.ownA * toNext.arm + j.other * toPrevious.arm;
  vec3 ofPrevious = j.ownB * toPrevious.arm + j.other * toNext.arm;
  return Derivative(weight * j.weight, rowOf(-(ofNext + ofPrevious), apex), rowOf(ofNext, next),
                    rowOf(ofPrevious, previous));
}

// What a term of the ring p, a, d, b adds, weight J^T J with J as rows of their columns.
void addRing(float weight, Motion rowP, Motion rowA, Motion rowD, Motion rowB) {
  addOuter(withP, weight, rowP, rowP);
  addOuter(withA, weight, rowP, rowA);
  addOuter(withD, weight, rowP, rowD);
  addOuter(withB, weight, rowP, rowB);
}

// The corner that previous, apex and next make in a layer.
Derivative differentiateLateral(ivec3 atPrevious, ivec3 atApex, ivec3 atNext, Vertex previous,
                                Vertex apex, Vertex next) {
  vec2 restAngle = restAngleAt(push.grid.size, atApex, atNext, atPrevious);
  return differentiate(push.grid.angleWeight, restAngle, previous, apex, next);
}

// The ring p, a, d, b in one layer; the corner at d leaves p alone.
void addLateralFace(float share, int layer) {
  Vertex atP = vertexAt(p, layer, centreP), atA = vertexAt(a, layer, centreA);
  Vertex atB = vertexAt(b, layer, centreB), atD = vertexAt(d, layer, centreD);
  ivec3 placeP = ivec3(p, layer), placeA = ivec3(a, layer);
  ivec3 placeB = ivec3(b, layer), placeD = ivec3(d, layer);
  Derivative c = differentiateLateral(placeB, placeP, placeA, atB, atP, atA);
  addRing(share * c.weight, c.apex, c.next, kNoMotion, c.previous);
  c = differentiateLateral(placeP, placeA, placeD, atP, atA, atD);
  addRing(share * c.weight, c.previous, c.apex, c.next, kNoMotion);
  c = differentiateLateral(placeD, placeB, placeP, atD, atB, atP);
  addRing(share * c.weight, c.next, kNoMotion, c.previous, c.apex);
}

void addWithinColumns(float weight, Motion rowP, Motion rowA) {
  addOuter(withP, weight, rowP, rowP);
  addOuter(withA, weight, rowP, rowA);
}

Derivative differentiateUpright(Vertex previous, Vertex apex, Vertex next) {
  return differentiate(push.grid.postAngleWeight, kRightAngle, previous, apex, next);
}

// The ring p, a, then a, p in the layer above.
void addVerticalFace(float share, int layer) {
  Vertex atP = vertexAt(p, layer, centreP), aboveP = vertexAt(p, layer + 1, centreP);
  Vertex atA = vertexAt(a, layer, centreA), aboveA = vertexAt(a, layer + 1, centreA);
  Derivative c = differentiateUpright(aboveP, atP, atA);
  addWithinColumns(share * c.weight, sum(c.apex, c.previous), c.next);
  c = differentiateUpright(atP, atA, aboveA);
  addWithinColumns(share * c.weight, c.previous, sum(c.apex, c.next));
  c = differentiateUpright(atA, aboveA, aboveP);
  addWithinColumns(share * c.weight, c.next, sum(c.apex, c.previous));
  c = differentiateUpright(aboveA, aboveP, atP);
  addWithinColumns(share * c.weight, sum(c.apex, c.next), c.previous);
}

// The block of the strut that leaves vertex `from` along an axis, with the damping.
mat3 strutBlock(Edge e, int from, int axis) {
  Spring spring = Spring(imageLoad(restLengths, from)[axis], push.grid.restResolution,
                         imageLoad(stiffnesses, from)[axis]);
  StrutHessian hessian = strutGaussNewtonHessian(e, spring);
  return outerProduct(hessian.outer * e.arm, e.arm) + mat3(hessian.identity + push.damping);
}

// Between p and a in one layer.
void addLateralStrut(float share, int layer, ivec2 from, int axis) {
  Vertex atP = vertexAt(p, layer, centreP), atA = vertexAt(a, layer, centreA);
  Edge e = edgeBetween(atP.position, atA.position, push.grid.resolution);
  mat3 hessian = strutBlock(e, indexInColumn(from, layer), axis);
  Block row = withLeverOfRow(atP.lever, Block(hessian, mat3(0), mat3(0), mat3(0)));
  add(withP, share, withLever(row, atP.lever));
  add(withA, -share, withLever(row, atA.lever));
}

// A vertical strut turns with its column.
void addVerticalStrut(inout Block block, int layer) {
  Edge e =
      edgeBetween(positionAt(p, layer), positionAt(p, layer + 1), push.grid.resolution);
  mat3 hessian = strutBlock(e, indexInColumn(p, layer), 2);
  block.ww += crossed(e.arm, crossedFromRight(hessian, e.arm));
}

void addFacesAround(inout Stencil stencil, int layer, int quarter) {
  ivec2 toA = ivec2(int(quarter == 0) - int(quarter == 2), int(quarter == 1) - int(quarter == 3));
  a = p + toA;
  b = p + ivec2(-toA.y, toA.x);
  d = a + b - p;
  centreA = centreOf(a);
  centreB = centreOf(b);
  centreD = centreOf(d);
  withP = withA = withB = withD = kNoBlock;
  ivec2 from = min(p, a), to = max(p, a);
  float share = hasSpan(push.grid.size, ivec3(from, layer), ivec3(to, layer)) ? 1.0 : 0.0;
  addLateralStrut(share, layer, from, quarter & 1);
  addLateralFace(hasCell(push.grid.size, min(p, d)) ? 1.0 : 0.0, layer);
  if (hasStrut(push.grid.size, ivec3(p, layer), 2)) {
    addVerticalFace(share, layer);
  }
  add(stencil.self, 1.0, withP);
  add(stencil.east, float(quarter == 0), withA);
  add(stencil.east, float(quarter == 3), withB);
  add(stencil.north, float(quarter == 1), withA);
  add(stencil.north, float(quarter == 0), withB);
  add(stencil.northEast, float(quarter == 0), withD);
  add(stencil.northWest, float(quarter == 1), withD);
}

void main() {
  p = pointOf(push.firstRow);
  if (!hasColumn(push.grid.size, p)) {
    return;
  }
  centreP = centreOf(p);
  Stencil stencil = kNoStencil;
  for (int layer = 0; layer < push.grid.size.z; ++layer) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      addFacesAround(stencil, layer, quarter);
    }
    if (hasStrut(push.grid.size, ivec3(p, layer), 2)) {
      addVerticalStrut(stencil.self, layer);
    }
  }
  storeStencil(writtenIndex(ivec2(push.grid.size)), stencil);
}
