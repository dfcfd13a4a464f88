// Compiles as GLSL and as C++: what the host and the renderer's shaders agree on.
#ifndef MORPHGRID_RENDER_TYPES_H
#define MORPHGRID_RENDER_TYPES_H
#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
namespace morphgrid {
using glm::ivec2;
using glm::ivec3;
using glm::mat4;
using glm::vec3;
using uint = std::uint32_t;
#define CONSTANT constexpr
#else
#define CONSTANT const
#endif

// Two triangles.
CONSTANT uint kVerticesPerQuad = 6u;

// A ball is drawn as a disc that faces the eye: a fan of triangles.
CONSTANT uint kDiscSides = 16u;
CONSTANT uint kVerticesPerDisc = 3u * kDiscSides;

// Bindings of the shaders that draw how rays sampled a mesh; buffers.
CONSTANT uint kBindingMeshVertices = 0u;   // three floats a vertex, local
CONSTANT uint kBindingMeshTriangles = 1u;  // three vertex indices a triangle
CONSTANT uint kBindingRayHits = 2u;  // vec4 a ray: where it hit, local; w is 0 where it missed
CONSTANT uint kBindingBalls = 3u;    // vec4 a ball: its centre, local; w is 0 for a missed ray

// Specialisation constant of struts and surfaces, bool: they show shares, not strains and sides.
CONSTANT uint kConstantShowsShares = 0u;
// And of surfaces, bool: others are seen through them.
CONSTANT uint kConstantIsVeil = 1u;

// A strut drawn as a line.
CONSTANT uint kVerticesPerLine = 2u;

// A strut drawn as a tube: a prism, of whose sides each has a triangle of the tips at both ends
// too.
CONSTANT uint kTubeSides = 6u;
CONSTANT uint kVerticesPerTubeSide = 12u;
CONSTANT uint kVerticesPerTube = kTubeSides * kVerticesPerTubeSide;

// A bar of a frame: its sides in so many pieces along it, and its two ends.
CONSTANT uint kBarPieces = 4u;
CONSTANT uint kVerticesPerBar = kVerticesPerQuad * (4u * kBarPieces + 2u);

// Struts and surfaces: bindings kBindingPositions and kBindingRest of solver_types.h, and shares;
// bars: kBindingPrinted of frame_types.h, with rotations behind positions. Local coordinates are
// spacings about the zero of the fixed-point positions. Texels, a vec4 a vertex: of its struts to
// +u, +v, +w; in the bottom layer, of its column.
CONSTANT uint kBindingShares = 4u;

struct StrutPush {
  mat4 clipFromLocal;
  vec3 eye;              // local
  float halfWidth;       // of a strut, in spacings; of a bar, in the sheet as printed
  vec3 towardsLight;     // local, unit length
  float resolution;      // Spacings per step of the fixed-point positions.
  ivec3 size;            // Vertices of the grid, see topology.h.
  int direction;         // 0, 1, 2: the struts to +u, +v, +w.
  float restResolution;  // Spacings per step of the fixed-point rest lengths.
  float pixelSize;       // What a pixel covers at a distance of 1.
  int stride;            // Lines join every n-th vertex along u and v, and the last one.
  float halfHeight;      // of a bar, across the sheet
};

struct SurfacePush {
  mat4 clipFromLocal;
  vec3 eye;           // local
  float resolution;   // Spacings per step of the fixed-point positions.
  vec3 towardsLight;  // local, unit length
  int refine;         // Quads along each side of a drawn cell.
  ivec3 size;         // Vertices of the grid, see topology.h.
  int isolineStride;  // Drawn cells from one isoline to the next.
  ivec2 drawnSize;    // Points of the lattice of every n-th vertex along u and v, and the last.
  int stride;         // n
};

// Local coordinates here are about the middle of the sampled box, whose diagonal is 1.
struct SamplingPush {
  mat4 clipFromLocal;
  vec3 eye;           // local
  float pixelSize;    // What a pixel covers at a distance of 1.
  vec3 towardsLight;  // local, unit length
  float radius;       // Radius of a ball, half the width of a spline.
  float lift;         // How far towards the eye it is drawn, so that the mesh does not cover it.
  int countU;         // Rays.
  int countV;
  int strideU;  // Rays from one drawn isoline to the next.
  int strideV;
  int refine;     // Pieces of a spline from one ray to the next.
  int direction;  // 0, 1: the splines along u, along v.
};

#ifdef __cplusplus
static_assert(sizeof(StrutPush) == 128);
static_assert(sizeof(SurfacePush) == 124);
static_assert(sizeof(SamplingPush) == 124);
}  // namespace morphgrid
#endif
#undef CONSTANT
#endif
