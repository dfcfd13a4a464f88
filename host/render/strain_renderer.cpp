#include "render/strain_renderer.h"

namespace morphgrid {

StrainRenderer::StrainRenderer(const Device& device, int width, int height, int samples)
    : device_(device),
      target_(device, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height),
              static_cast<std::uint32_t>(samples)),
      painter_(device, target_.pass()) {}

Image StrainRenderer::draw(const DeviceGrid& grid, const GridLook& look,
                           const Eigen::Isometry3d& worldFromGrid, const Camera& camera) {
  const GridResources resources(device_, grid);
  const LocalView view = viewOf(grid, worldFromGrid, camera, height());
  return {static_cast<int>(target_.size().width), height(),
          target_.render([&](const CommandBuffer& commands) {
            painter_.draw(commands, resources, look, view);
          })};
}

Image StrainRenderer::drawStruts(const DeviceGrid& grid, const Eigen::Isometry3d& worldFromGrid,
                                 const Camera& camera) {
  return draw(grid, {.style = pictureStyleOf(grid)}, worldFromGrid, camera);
}

Image StrainRenderer::drawSurface(const DeviceGrid& grid, const Eigen::Isometry3d& worldFromGrid,
                                  const Camera& camera) {
  return draw(grid, {.isSurface = true}, worldFromGrid, camera);
}

}  // namespace morphgrid
