// The matrix of a level, written.
layout(std430, binding = kBindingCoarseMatrix + 3u * kStencilSelf + 0u) writeonly buffer Self0 {
  vec4 newSelf0[];
};
layout(std430, binding = kBindingCoarseMatrix + 3u * kStencilSelf + 1u) writeonly buffer Self1 {
  vec4 newSelf1[];
};
layout(std430, binding = kBindingCoarseMatrix + 3u * kStencilSelf + 2u) writeonly buffer Self2 {
  vec4 newSelf2[];
};
layout(std430, binding = kBindingCoarseMatrix + 3u * kStencilEast + 0u) writeonly buffer East0 {
  vec4 newEast0[];
};
layout(std430, binding = kBindingCoarseMatrix + 3u * kStencilEast + 1u) writeonly buffer East1 {
  vec4 newEast1[];
};
layout(std430, binding = kBindingCoarseMatrix + 3u * kStencilEast + 2u) writeonly buffer East2 {
  vec4 newEast2[];
};
layout(std430, binding = kBindingCoarseMatrix + 3u * kStencilNorth + 0u) writeonly buffer North0 {
  vec4 newNorth0[];
};
layout(std430, binding = kBindingCoarseMatrix + 3u * kStencilNorth + 1u) writeonly buffer North1 {
  vec4 newNorth1[];
};
layout(std430, binding = kBindingCoarseMatrix + 3u * kStencilNorth + 2u) writeonly buffer North2 {
  vec4 newNorth2[];
};
layout(std430, binding = kBindingCoarseMatrix + 3u * kStencilNorthEast + 0u) writeonly buffer NorthEast0 {
  vec4 newNorthEast0[];
};
layout(std430, binding = kBindingCoarseMatrix + 3u * kStencilNorthEast + 1u) writeonly buffer NorthEast1 {
  vec4 newNorthEast1[];
};
layout(std430, binding = kBindingCoarseMatrix + 3u * kStencilNorthEast + 2u) writeonly buffer NorthEast2 {
  vec4 newNorthEast2[];
};
layout(std430, binding = kBindingCoarseMatrix + 3u * kStencilNorthWest + 0u) writeonly buffer NorthWest0 {
  vec4 newNorthWest0[];
};
layout(std430, binding = kBindingCoarseMatrix + 3u * kStencilNorthWest + 1u) writeonly buffer NorthWest1 {
  vec4 newNorthWest1[];
};
layout(std430, binding = kBindingCoarseMatrix + 3u * kStencilNorthWest + 2u) writeonly buffer NorthWest2 {
  vec4 newNorthWest2[];
};

struct Stencil {
  Block self, east, north, northEast, northWest;
};

const Stencil kNoStencil = Stencil(kNoBlock, kNoBlock, kNoBlock, kNoBlock, kNoBlock);

void storeStencil(int point, Stencil stencil) {
  STORE_BLOCK(newSelf0, newSelf1, newSelf2, point, stencil.self);
  STORE_BLOCK(newEast0, newEast1, newEast2, point, stencil.east);
  STORE_BLOCK(newNorth0, newNorth1, newNorth2, point, stencil.north);
  STORE_BLOCK(newNorthEast0, newNorthEast1, newNorthEast2, point, stencil.northEast);
  STORE_BLOCK(newNorthWest0, newNorthWest1, newNorthWest2, point, stencil.northWest);
}
