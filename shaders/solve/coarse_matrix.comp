// The Galerkin product P^T A P: five blocks of a coarse point's row.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/multigrid_types.h"
#include "solve/block.glsl"
#include "solve/point_matrix.glsl"
#include "solve/point_rows.glsl"
#include "solve/store_stencil.glsl"
#include "solve/transfer.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;

layout(binding = kBindingCoarseCentres, rgba32i) readonly uniform iimageBuffer coarseCentres;
layout(binding = kBindingLevers, rgba32i) readonly uniform iimageBuffer levers;

ivec2 point;
ivec4 centre, eastCentre, northCentre, northEastCentre, northWestCentre;

ivec4 centreOf(ivec2 offset) {
  return imageLoad(coarseCentres, coarseIndex(point + offset));
}

// A fine block, its row already the coarse point's, becomes a part of a coarse one.
void addBlock(inout Block sum, Block a, ivec2 fine, ivec4 lever, ivec2 offset, ivec4 columnCentre) {
  add(sum, shareOf(fine, point + offset), withLever(a, leverBetween(columnCentre, lever)));
}

void addRow(inout Stencil stencil, ivec2 row) {
  float share = shareOf(row, point);
  vec3 rowLever = leverBetween(centre, imageLoad(levers, fineIndex(row)));
  [[unroll]] for (int v = -1; v <= 1; ++v) {
    [[unroll]] for (int u = -1; u <= 1; ++u) {
      ivec2 column = row + ivec2(u, v);
      Block a = kNoBlock;
      add(a, share, withLeverOfRow(rowLever, blockBetween(row, ivec2(u, v))));
      ivec4 lever = imageLoad(levers, fineIndex(column));
      addBlock(stencil.self, a, column, lever, ivec2(0, 0), centre);
      if (u >= 0) {
        addBlock(stencil.east, a, column, lever, ivec2(1, 0), eastCentre);
      }
      if (v >= 0) {
        addBlock(stencil.north, a, column, lever, ivec2(0, 1), northCentre);
      }
      if (u >= 0 && v >= 0) {
        addBlock(stencil.northEast, a, column, lever, ivec2(1, 1), northEastCentre);
      }
      if (u <= 0 && v >= 0) {
        addBlock(stencil.northWest, a, column, lever, ivec2(-1, 1), northWestCentre);
      }
    }
  }
}

void main() {
  matrixSize = push.fineSize;
  point = pointOf(push.firstRow);
  if (!hasPoint(push.coarseSize, point)) {
    return;
  }
  centre = centreOf(ivec2(0, 0));
  eastCentre = centreOf(ivec2(1, 0));
  northCentre = centreOf(ivec2(0, 1));
  northEastCentre = centreOf(ivec2(1, 1));
  northWestCentre = centreOf(ivec2(-1, 1));
  Stencil stencil = kNoStencil;
  for (int v = -1; v <= 1; ++v) {
    for (int u = -1; u <= 1; ++u) {
      addRow(stencil, finePointOf(point) + ivec2(u, v));
    }
  }
  storeStencil(writtenIndex(push.coarseSize), stencil);
}
