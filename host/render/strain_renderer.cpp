#include "render/strain_renderer.h"

#include <cassert>

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
  return picture(
      [&](const CommandBuffer& commands) { painter_.draw(commands, resources, look, view); });
}

Image StrainRenderer::picture(const std::function<void(const CommandBuffer&)>& draw) {
  return {static_cast<int>(target_.size().width), height(), target_.render(draw)};
}

Image StrainRenderer::drawStruts(const DeviceGrid& grid, const Eigen::Isometry3d& worldFromGrid,
                                 const Camera& camera) {
  return draw(grid, {.style = pictureStyleOf(grid)}, worldFromGrid, camera);
}

Image StrainRenderer::drawSurface(const DeviceGrid& grid, const Eigen::Isometry3d& worldFromGrid,
                                  const Camera& camera) {
  return draw(grid, {.isSurface = true}, worldFromGrid, camera);
}

Image StrainRenderer::drawStrutShares(const DeviceGrid& grid, const StrutValues& shares,
                                      const Camera& camera) {
  assert(static_cast<int>(shares.u.size()) == grid.shape().vertexCount());
  const StrutShares onDevice(device_, shares);
  const GridResources resources(device_, grid, &onDevice);
  const LocalView view = viewOf(grid, Eigen::Isometry3d::Identity(), camera, height());
  return picture([&](const CommandBuffer& commands) {
    painter_.draw(commands, resources,
                  {.style = pictureStyleOf(grid), .directions = {true, true, false}}, view);
  });
}

Image StrainRenderer::drawSurfaceShares(const PlacedGrid& surface, const Eigen::VectorXd& shares,
                                        const PlacedGrid& veil, const Camera& camera) {
  const GridShape& shape = surface.grid.shape();
  assert(shares.size() == shape.layerVertexCount());
  const StrutShares onDevice(device_, StrutValues(shape), shares);
  const GridResources surfaceResources(device_, surface.grid, &onDevice);
  const GridResources veilResources(device_, veil.grid);
  const auto placed = [&](const PlacedGrid& grid) {
    return viewOf(grid.grid, grid.worldFromGrid, camera, height());
  };
  return picture([&](const CommandBuffer& commands) {
    painter_.draw(commands, surfaceResources, {.isSurface = true}, placed(surface));
    painter_.draw(commands, veilResources, {.isSurface = true, .isVeil = true}, placed(veil));
  });
}

}  // namespace morphgrid
