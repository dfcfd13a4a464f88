// D^-1: the inverses of the Hessian's 3 x 3 blocks on the diagonal, gathered vertex by vertex. Runs once
// in several cycles, so it may project a corner once for each of its vertices.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/hessian_types.h"
#include "shared/topology.h"
#include "energy/strut.glsl"
#include "solve/printed_corners.glsl"
#include "solve/symmetric_inverse.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;

layout(binding = kBindingPositions, rgba32i) readonly uniform iimageBuffer positions;
layout(binding = kBindingRest, rgba32i) readonly uniform iimageBuffer restLengths;
layout(binding = kBindingStiffness, rgba32f) readonly uniform imageBuffer stiffnesses;
layout(std430, binding = kBindingInverseDiagonal) writeonly buffer Diagonal { vec4 diagonals[]; };
layout(std430, binding = kBindingInverseOffDiagonal) writeonly buffer OffDiagonal {
  vec4 offDiagonals[];
};
layout(push_constant) uniform Push { HessianPush push; };

// A pivot below this share of its diagonal counts as absent: its row and column of the inverse are zero.
// In the plane nothing holds z.
const float kLeastPivot = 1e-6;

ivec3 vertex;
Symmetric block = Symmetric(vec3(0), vec3(0));

int indexOf(ivec3 v) { return vertexIndex(push.grid.size, v); }

ivec4 positionAt(ivec3 v) { return imageLoad(positions, indexOf(v)); }

Edge edgeBetween(ivec3 from, ivec3 to) {
  return edgeBetween(positionAt(from), positionAt(to), push.grid.resolution);
}

void addOuter(float weight, vec3 j) {
  block.diagonal += weight * j * j;
  block.off += weight * j.yxx * j.zzy;
}

// The strut that leaves `from` along `axis`, from or towards the vertex.
void addStrut(ivec3 from, int axis) {
  if (!hasStrut(push.grid.size, from, axis)) {
    return;
  }
  Edge e = edgeBetween(from, neighbour(from, axis, 1));
  Spring spring = Spring(imageLoad(restLengths, indexOf(from))[axis], push.grid.restResolution,
                         imageLoad(stiffnesses, indexOf(from))[axis]);
  StrutHessian hessian = strutGaussNewtonHessian(e, spring);
  addOuter(hessian.outer, e.arm);
  block.diagonal += hessian.identity + push.damping;
}

void addCorner(ivec3 apex, ivec3 armEnd, ivec3 otherEnd) {
  if (!hasCorner(push.grid.size, armEnd, otherEnd)) {
    return;
  }
  Edge a = edgeBetween(apex, armEnd);
  Edge b = edgeBetween(apex, otherEnd);
  vec2 restAngle = restAngleAt(push.grid.size, apex, armEnd, otherEnd);
  CornerJacobian j = cornerJacobian(a, b, restAngle);
  vec3 atEnd = j.ownA * a.arm + j.other * b.arm;
  vec3 atOtherEnd = j.ownB * b.arm + j.other * a.arm;
  float weight = armEnd.z == otherEnd.z ? push.grid.angleWeight : push.grid.postAngleWeight;
  addOuter(weight * j.weight, vertex == apex ? atEnd + atOtherEnd : atEnd);
}

// The corners whose apex is the vertex, and those at its neighbours with it as an end.
void addCorners(int axisA, int axisB) {
  for (int signs = 0; signs < 4; ++signs) {
    ivec3 a = unitStep(axisA) * (1 - 2 * (signs & 1));
    ivec3 b = unitStep(axisB) * (1 - (signs & 2));
    addCorner(vertex, vertex + a, vertex + b);
    addCorner(vertex - a, vertex, vertex - a + b);
    addCorner(vertex - b, vertex, vertex - b + a);
  }
}

void main() {
  vertex = ivec3(gl_GlobalInvocationID);
  if (!hasVertex(push.grid.size, vertex)) {
    return;
  }
  for (int axis = 0; axis < 3; ++axis) {
    addStrut(vertex, axis);
    addStrut(neighbour(vertex, axis, -1), axis);
    addCorners(axis, axis < 2 ? axis + 1 : 0);
  }
  Symmetric inverse = inverseOf(block, kLeastPivot * block.diagonal);
  diagonals[indexOf(vertex)] = vec4(inverse.diagonal, 0.0);
  offDiagonals[indexOf(vertex)] = vec4(inverse.off, 0.0);
}
