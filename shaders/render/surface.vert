// The Catmull-Rom surface through the middle layer: two triangles of a quad of its refined lattice.
// With kShowsShares, and the shares of its columns.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/render_types.h"
#include "shared/solver_types.h"
#include "shared/topology.h"
#include "render/catmull_rom.glsl"

layout(constant_id = kConstantShowsShares) const bool kShowsShares = false;

layout(binding = kBindingPositions) uniform isamplerBuffer positions;
layout(binding = kBindingShares) uniform samplerBuffer shares;
layout(push_constant) uniform Push { SurfacePush push; };

layout(location = 0) centroid out vec3 point;
layout(location = 1) centroid out vec3 normal;  // Zero where there is none.
layout(location = 2) out vec2 parameter;  // In cells.
layout(location = 3) centroid out float share;

const ivec2 kCorners[kVerticesPerQuad] =
    ivec2[](ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 0), ivec2(1, 1), ivec2(0, 1));

struct Spline {
  int segment;
  vec4 point;
  vec4 tangent;
};

// Beyond an end of the lattice there is no point: the parabola through the last three stands in.
vec4 withinLattice(vec4 weights, int segment, int count) {
  vec3 extrapolated = count > 2 ? vec3(3, -3, 1) : vec3(2, -1, 0);
  if (segment == 0) {
    weights = vec4(0, weights.yzw + weights.x * extrapolated);
  }
  if (segment == count - 2) {
    weights = vec4(weights.xyz + weights.w * extrapolated.zyx, 0);
  }
  return weights;
}

Spline splineAt(int sampleIndex, int count) {
  int segment = min(sampleIndex / push.refine, count - 2);
  float t = float(sampleIndex - segment * push.refine) / float(push.refine);
  return Spline(segment, withinLattice(pointWeights(t), segment, count),
                withinLattice(tangentWeights(t), segment, count));
}

// The column at a point of the drawn lattice. Points beyond weigh nothing.
ivec2 columnAt(ivec2 drawn) {
  return thinnedPoint(push.size.xy, push.stride, nearestPoint(push.drawnSize, drawn));
}

vec3 pointAt(ivec3 vertex) {
  return vec3(texelFetch(positions, vertexIndex(push.size, vertex)).xyz);
}

// A point of the middle layer, or half way between the middle two.
vec3 middlePoint(ivec2 drawn) {
  ivec2 column = columnAt(drawn);
  int layers = push.size.z;
  vec3 upper = pointAt(ivec3(column, layers / 2));
  if (layers % 2 == 0) {
    upper = 0.5 * (pointAt(ivec3(column, layers / 2 - 1)) + upper);
  }
  return upper * push.resolution;
}

// Its place in the refined lattice.
ivec2 placeVertex() {
  int quadsU = (push.drawnSize.x - 1) * push.refine;
  int quad = gl_VertexIndex / int(kVerticesPerQuad);
  ivec2 lattice =
      ivec2(quad % quadsU, quad / quadsU) + kCorners[gl_VertexIndex % int(kVerticesPerQuad)];
  Spline u = splineAt(lattice.x, push.drawnSize.x);
  Spline v = splineAt(lattice.y, push.drawnSize.y);

  point = vec3(0);
  vec3 alongU = vec3(0), alongV = vec3(0);
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      vec3 at = middlePoint(ivec2(u.segment, v.segment) + ivec2(i, j) - 1);
      point += u.point[i] * v.point[j] * at;
      alongU += u.tangent[i] * v.point[j] * at;
      alongV += u.point[i] * v.tangent[j] * at;
    }
  }
  vec3 area = cross(alongU, alongV);
  float scale = length(alongU) * length(alongV);
  normal = length(area) > 1e-4 * scale ? normalize(area) : vec3(0);
  parameter = vec2(lattice) / float(push.refine);
  gl_Position = push.clipFromLocal * vec4(point, 1);
  return lattice;
}

float shareAt(ivec2 drawn) {
  return texelFetch(shares, pointIndex(push.size.xy, columnAt(drawn))).a;
}

// Linear between vertices: a spline would leave their range.
float shareBetween(ivec2 lattice) {
  ivec2 low = min(lattice / push.refine, push.drawnSize - 2);
  vec2 t = vec2(lattice - low * push.refine) / float(push.refine);
  float front = mix(shareAt(low), shareAt(low + ivec2(1, 0)), t.x);
  float back = mix(shareAt(low + ivec2(0, 1)), shareAt(low + ivec2(1, 1)), t.x);
  return mix(front, back, t.y);
}

void main() {
  ivec2 lattice = placeVertex();
  share = kShowsShares ? shareBetween(lattice) : 0;
}
