// A corner of a triangle of a mesh, with the triangle's own normal: meshes have no others that hold.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/render_types.h"

layout(binding = kBindingMeshVertices) readonly buffer Vertices { float coordinates[]; };
layout(binding = kBindingMeshTriangles) readonly buffer Triangles { int corners[]; };
layout(push_constant) uniform Push { SamplingPush push; };

layout(location = 0) out vec3 point;
layout(location = 1) flat out vec3 normal;  // Zero where there is none.

vec3 cornerOf(int triangle, int corner) {
  int first = 3 * corners[3 * triangle + corner];
  return vec3(coordinates[first], coordinates[first + 1], coordinates[first + 2]);
}

vec3 direction(vec3 arm) { return arm / max(length(arm), 1e-18); }

void main() {
  int triangle = gl_VertexIndex / 3;
  vec3 a = cornerOf(triangle, 0), b = cornerOf(triangle, 1), c = cornerOf(triangle, 2);
  normal = direction(cross(direction(b - a), direction(c - a)));
  point = gl_VertexIndex % 3 == 0 ? a : (gl_VertexIndex % 3 == 1 ? b : c);
  gl_Position = push.clipFromLocal * vec4(point, 1);
}
