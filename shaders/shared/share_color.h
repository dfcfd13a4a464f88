// Compiles as GLSL and as C++: colours for shares of something that should stay between 0 and 1.
#ifndef MORPHGRID_SHARE_COLOR_H
#define MORPHGRID_SHARE_COLOR_H
#ifdef __cplusplus
#include <glm/glm.hpp>
namespace morphgrid {
using glm::mix;
using glm::vec3;
#define MORPHGRID_INLINE inline
#else
#define MORPHGRID_INLINE
#endif

const float kShareTolerance = 1e-5f;  // So much beyond 0 or 1 is rounding.

// 0 .. 1: grey green over yellow to dark red; magenta above, blue below.
MORPHGRID_INLINE vec3 shareColor(float share) {
  const vec3 none = vec3(0.62f, 0.80f, 0.70f);
  const vec3 middle = vec3(0.98f, 0.80f, 0.20f);
  const vec3 full = vec3(0.70f, 0.08f, 0.05f);
  const vec3 over = vec3(0.85f, 0.00f, 0.95f);
  const vec3 under = vec3(0.10f, 0.35f, 0.95f);
  if (share > 1.0f + kShareTolerance) {
    return over;
  }
  if (share < -kShareTolerance) {
    return under;
  }
  return share < 0.5f ? mix(none, middle, 2.0f * share) : mix(middle, full, 2.0f * share - 1.0f);
}

#undef MORPHGRID_INLINE
#ifdef __cplusplus
}  // namespace morphgrid
#endif
#endif
