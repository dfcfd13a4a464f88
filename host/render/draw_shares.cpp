#include "render/draw_shares.h"

#include <cassert>

#include "gpu/offscreen_target.h"
#include "render/grid_painter.h"

namespace morphgrid {
namespace {

OffscreenTarget createTarget(const Device& device, int width, int height, int samples) {
  return {device, static_cast<uint>(width), static_cast<uint>(height), static_cast<uint>(samples)};
}

}  // namespace

Image drawStrutShares(const Device& device, const DeviceGrid& grid, const StrutValues& shares,
                      const Camera& camera, int width, int height, int samples) {
  assert(static_cast<int>(shares.u.size()) == grid.shape().vertexCount());
  const StrutShares onDevice(device, shares);
  const GridResources resources(device, grid, &onDevice);
  OffscreenTarget target = createTarget(device, width, height, samples);
  const GridPainter painter(device, target.pass());
  const LocalView view = viewOf(grid, Eigen::Isometry3d::Identity(), camera, height);
  return {width, height, target.render([&](const CommandBuffer& commands) {
            painter.draw(commands, resources,
                         {.style = pictureStyleOf(grid), .directions = {true, true, false}}, view);
          })};
}

Image drawSurfaceShares(const Device& device, const PlacedGrid& surface,
                        const Eigen::VectorXd& shares, const PlacedGrid& veil, const Camera& camera,
                        int width, int height, int samples) {
  const GridShape& shape = surface.grid.shape();
  assert(shares.size() == shape.layerVertexCount());
  const StrutShares onDevice(device, StrutValues(shape), shares);
  const GridResources surfaceResources(device, surface.grid, &onDevice);
  const GridResources veilResources(device, veil.grid);
  OffscreenTarget target = createTarget(device, width, height, samples);
  const GridPainter painter(device, target.pass());
  const auto placed = [&](const PlacedGrid& grid) {
    return viewOf(grid.grid, grid.worldFromGrid, camera, height);
  };
  return {width, height, target.render([&](const CommandBuffer& commands) {
            painter.draw(commands, surfaceResources, {.isSurface = true}, placed(surface));
            painter.draw(commands, veilResources, {.isSurface = true, .isVeil = true},
                         placed(veil));
          })};
}

}  // namespace morphgrid
