// A kernel writes one point an invocation, in chunks of whole rows of points. Where it reads, points count
// from the first of all; what it writes is bound from the chunk's first row on.
#include "shared/topology.h"

ivec2 pointOf(int firstRow) {
  return ivec2(gl_GlobalInvocationID.xy) + ivec2(0, firstRow);
}

int writtenIndex(ivec2 size) { return pointIndex(size, ivec2(gl_GlobalInvocationID.xy)); }
