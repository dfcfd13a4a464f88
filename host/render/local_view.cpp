#include "render/local_view.h"

#include <cmath>

namespace morphgrid {
namespace {

const glm::dvec3 kTowardsLightInView(-0.45, 0.65, 0.62);

}  // namespace

LocalView localView(const glm::dmat4& worldFromLocal, const Camera& camera, int imageHeight) {
  const glm::dmat4 viewFromLocal = camera.viewFromWorld * worldFromLocal;
  const glm::dmat4 localFromView = glm::inverse(viewFromLocal);
  const double pixelSize = 2 / (imageHeight * std::abs(camera.clipFromView[1][1]));
  return {glm::mat4(camera.clipFromView * viewFromLocal), glm::vec3(localFromView[3]),
          glm::vec3(glm::normalize(localFromView * glm::dvec4(kTowardsLightInView, 0))),
          static_cast<float>(pixelSize)};
}

}  // namespace morphgrid
