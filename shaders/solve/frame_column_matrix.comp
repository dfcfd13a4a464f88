// The columns' matrix P^T H P of a frame: a column of joints moves rigidly about its centre, the joint in the
// middle layer, and strains its lateral bars alone.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/frame_types.h"
#include "solve/frame_blocks.glsl"
#include "solve/point_rows.glsl"
#include "solve/store_stencil.glsl"

ivec4 centreOf(ivec3 vertex) {
  return imageLoad(joints, indexOf(ivec3(vertex.xy, push.centreLayer)));
}

vec3 leverOf(ivec3 vertex) {
  return armBetween(centreOf(vertex), imageLoad(joints, indexOf(vertex)), push.grid.resolution);
}

// The bar that leaves `from`, towards or away from the column.
void addBar(inout Block self, inout Block other, ivec3 from, int axis, bool leaves) {
  float share = hasStrut(push.grid.size, from, axis) ? 1.0 : 0.0;
  BarRows rows = rowsOf(from, axis);
  End a = End(false, leverOf(from)), b = End(true, leverOf(neighbour(from, axis, 1)));
  End here = a, there = b;
  if (!leaves) {
    here = b;
    there = a;
  }
  add(self, share, betweenEnds(rows, here, here));
  add(other, leaves ? share : 0.0, betweenEnds(rows, here, there));
}

void main() {
  ivec2 column = pointOf(push.firstRow);
  if (!hasColumn(push.grid.size, column)) {
    return;
  }
  Stencil stencil = kNoStencil;
  for (int layer = 0; layer < push.grid.size.z; ++layer) {
    ivec3 vertex = ivec3(column, layer);
    for (int leaves = 0; leaves < 2; ++leaves) {
      addBar(stencil.self, stencil.east, neighbour(vertex, 0, leaves - 1), 0, leaves == 1);
      addBar(stencil.self, stencil.north, neighbour(vertex, 1, leaves - 1), 1, leaves == 1);
    }
    if (kIsLoaded) {
      add(stencil.self, 1.0, ofHold(indexOf(vertex), leverOf(vertex)));
    }
    // Damping holds posts too.
    if (hasStrut(push.grid.size, vertex, 2)) {
      vec3 post = armBetween(imageLoad(joints, indexOf(vertex)),
                             imageLoad(joints, indexOf(neighbour(vertex, 2, 1))), push.grid.resolution);
      stencil.self.ww += crossed(post, crossedFromRight(mat3(push.damping), post));
    }
  }
  storeStencil(writtenIndex(ivec2(push.grid.size)), stencil);
}
