// The matrix of a level, read: five blocks a point of its stencil of nine.
#include "shared/topology.h"

layout(binding = kBindingMatrix + 3u * kStencilSelf + 0u, rgba32f) readonly uniform imageBuffer
    self0;
layout(binding = kBindingMatrix + 3u * kStencilSelf + 1u, rgba32f) readonly uniform imageBuffer
    self1;
layout(binding = kBindingMatrix + 3u * kStencilSelf + 2u, rgba32f) readonly uniform imageBuffer
    self2;
layout(binding = kBindingMatrix + 3u * kStencilEast + 0u, rgba32f) readonly uniform imageBuffer
    east0;
layout(binding = kBindingMatrix + 3u * kStencilEast + 1u, rgba32f) readonly uniform imageBuffer
    east1;
layout(binding = kBindingMatrix + 3u * kStencilEast + 2u, rgba32f) readonly uniform imageBuffer
    east2;
layout(binding = kBindingMatrix + 3u * kStencilNorth + 0u, rgba32f) readonly uniform imageBuffer
    north0;
layout(binding = kBindingMatrix + 3u * kStencilNorth + 1u, rgba32f) readonly uniform imageBuffer
    north1;
layout(binding = kBindingMatrix + 3u * kStencilNorth + 2u, rgba32f) readonly uniform imageBuffer
    north2;
layout(binding = kBindingMatrix + 3u * kStencilNorthEast + 0u, rgba32f) readonly uniform imageBuffer
    northEast0;
layout(binding = kBindingMatrix + 3u * kStencilNorthEast + 1u, rgba32f) readonly uniform imageBuffer
    northEast1;
layout(binding = kBindingMatrix + 3u * kStencilNorthEast + 2u, rgba32f) readonly uniform imageBuffer
    northEast2;
layout(binding = kBindingMatrix + 3u * kStencilNorthWest + 0u, rgba32f) readonly uniform imageBuffer
    northWest0;
layout(binding = kBindingMatrix + 3u * kStencilNorthWest + 1u, rgba32f) readonly uniform imageBuffer
    northWest1;
layout(binding = kBindingMatrix + 3u * kStencilNorthWest + 2u, rgba32f) readonly uniform imageBuffer
    northWest2;

ivec2 matrixSize;

int nearestIndex(ivec2 p) { return pointIndex(matrixSize, nearestPoint(matrixSize, p)); }

Block selfBlock(int point) {
  return BLOCK_AT(self0, self1, self2, point);
}

Block eastBlock(int point) {
  return BLOCK_AT(east0, east1, east2, point);
}

Block northBlock(int point) {
  return BLOCK_AT(north0, north1, north2, point);
}

Block northEastBlock(int point) {
  return BLOCK_AT(northEast0, northEast1, northEast2, point);
}

Block northWestBlock(int point) {
  return BLOCK_AT(northWest0, northWest1, northWest2, point);
}

// Row p, column p + offset of the matrix.
Block blockBetween(ivec2 p, ivec2 offset) {
  int here = nearestIndex(p);
  int there = nearestIndex(p + offset);
  if (offset.y == 0) {
    return offset.x == 0   ? selfBlock(here)
           : offset.x == 1 ? eastBlock(here)
                           : transposed(eastBlock(there));
  }
  if (offset.y == 1) {
    return offset.x == 0   ? northBlock(here)
           : offset.x == 1 ? northEastBlock(here)
                           : northWestBlock(here);
  }
  return offset.x == 0   ? transposed(northBlock(there))
         : offset.x == 1 ? transposed(northWestBlock(there))
                         : transposed(northEastBlock(there));
}
