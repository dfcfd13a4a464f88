// Compiles as GLSL and as C++: the colour of a strut by its strain.
#ifndef MORPHGRID_STRAIN_COLOR_H
#define MORPHGRID_STRAIN_COLOR_H
#ifdef __cplusplus
#include <glm/glm.hpp>
namespace morphgrid {
using glm::mix;
using glm::vec3;
#define MORPHGRID_INLINE inline
#else
#define MORPHGRID_INLINE
#endif

const float kFullColorStrain = 0.2f;  // At and beyond this strain the colours are saturated.

// (|e| - L)/L in [-0.2, 0.2] -> dark blue, bright green (0), bright red; linear RGB-space steps.
MORPHGRID_INLINE vec3 strainColor(float strain) {
  const vec3 shortened = vec3(0.0f, 0.0f, 0.5f);
  const vec3 relaxed = vec3(0.0f, 1.0f, 0.0f);
  const vec3 stretched = vec3(1.0f, 0.0f, 0.0f);
  float t = strain / kFullColorStrain;
  t = t < -1.0f ? -1.0f : (t > 1.0f ? 1.0f : t);
  return t < 0.0f ? mix(relaxed, shortened, -t) : mix(relaxed, stretched, t);
}

#undef MORPHGRID_INLINE
#ifdef __cplusplus
}  // namespace morphgrid
#endif
#endif
