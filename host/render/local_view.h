#pragma once
#include <glm/glm.hpp>

#include "render/camera.h"

namespace morphgrid {

/// What a camera sees, in coordinates of a size that single precision holds: what shaders get.
struct LocalView {
  glm::mat4 clipFromLocal;
  glm::vec3 eye;
  glm::vec3 towardsLight;  ///< Unit length.
  float pixelSize;         ///< What a pixel covers at a distance of 1.
};

/// worldFromLocal: rotation, translation and uniform scale. imageHeight in pixels.
LocalView localView(const glm::dmat4& worldFromLocal, const Camera& camera, int imageHeight);

}  // namespace morphgrid
