// The Galerkin product P^T A P: five blocks of a coarse point's row.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/multigrid_types.h"
#include "solve/interpolation.glsl"
#include "solve/point_matrix.glsl"
#include "solve/point_rows.glsl"
#include "solve/store_stencil.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;

ivec2 point;

// Loops that run once at most: an `if` would not spare its work.
#define WHERE(condition) for (bool isTrue = condition; isTrue; isTrue = false)

// Adds P^T A between the point and a fine column, of the fine row that leads there by `offset`.
void addRow(inout Block sum, ivec2 column, ivec2 offset) {
  ivec2 row = column - offset;
  WHERE(shareOf(row, point) > 0.0) {
    add(sum, 1.0, timesRestriction(interpolationOf(row, point), blockBetween(row, offset)));
  }
}

// Adds the part of the coarse column that lies in a direction from the point.
void addColumn(inout Block sum, Block rows, ivec2 column, ivec2 direction) {
  WHERE(shareOf(column, point + direction) > 0.0) {
    add(sum, 1.0, timesInterpolation(rows, interpolationOf(column, point + direction)));
  }
}

void addColumns(inout Stencil stencil, ivec2 column) {
  Block rows = kNoBlock;
  [[unroll]] for (int v = -1; v <= 1; ++v) {
    [[unroll]] for (int u = -1; u <= 1; ++u) {
      addRow(rows, column, ivec2(u, v));
    }
  }
  addColumn(stencil.self, rows, column, ivec2(0, 0));
  addColumn(stencil.east, rows, column, ivec2(1, 0));
  addColumn(stencil.north, rows, column, ivec2(0, 1));
  addColumn(stencil.northEast, rows, column, ivec2(1, 1));
  addColumn(stencil.northWest, rows, column, ivec2(-1, 1));
}

void main() {
  matrixSize = push.fineSize;
  point = pointOf(push.firstRow);
  if (!hasPoint(push.coarseSize, point)) {
    return;
  }
  Stencil stencil = kNoStencil;
  for (int v = -1; v <= 2; ++v) {
    for (int u = -2; u <= 2; ++u) {
      addColumns(stencil, finePointOf(point) + ivec2(u, v));
    }
  }
  storeStencil(writtenIndex(push.coarseSize), stencil);
}
