// Compiles as GLSL and as C++: what the host and the renderer's shaders agree on.
#ifndef MORPHGRID_RENDER_TYPES_H
#define MORPHGRID_RENDER_TYPES_H
#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
namespace morphgrid {
using glm::mat4;
using glm::vec3;
using uint = std::uint32_t;
#define CONSTANT constexpr
#else
#define CONSTANT const
#endif

// Two triangles.
CONSTANT uint kVerticesPerQuad = 6u;

// Bindings kBindingPositions and kBindingRest of solver_types.h. Local coordinates are spacings
// about the zero of the fixed-point positions.

struct StrutPush {
  mat4 clipFromLocal;
  vec3 eye;           // local
  float halfWidth;    // of a strut, in spacings
  vec3 towardsLight;  // local, unit length
  float resolution;   // Spacings per step of the fixed-point positions.
  int verticesU;
  int verticesV;
  int layers;
  int direction;         // 0, 1, 2: the struts to +u, +v, +w.
  float restResolution;  // Spacings per step of the fixed-point rest lengths.
  float pixelSize;       // What a pixel covers at a distance of 1.
};

struct SurfacePush {
  mat4 clipFromLocal;
  vec3 eye;           // local
  float resolution;   // Spacings per step of the fixed-point positions.
  vec3 towardsLight;  // local, unit length
  int refine;         // Quads along each side of a cell.
  int verticesU;
  int verticesV;
  int layers;
  int isolineStride;  // Cells from one isoline to the next.
};

#ifdef __cplusplus
static_assert(sizeof(StrutPush) == 120);
static_assert(sizeof(SurfacePush) == 112);
}  // namespace morphgrid
#endif
#undef CONSTANT
#endif
