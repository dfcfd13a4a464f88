#include "render/strain_renderer.h"

#include "render/grid_drawing.h"
#include "render/strut_frag.h"
#include "render/strut_vert.h"
#include "render/surface_frag.h"
#include "render/surface_vert.h"
#include "shared/solver_types.h"

namespace morphgrid {
namespace {

constexpr auto kTexels = vk::DescriptorType::eUniformTexelBuffer;

}  // namespace

StrainRenderer::StrainRenderer(const Device& device, int width, int height, int samples)
    : device_(device),
      target_(device, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height),
              static_cast<std::uint32_t>(samples)),
      strutPipeline_(device, {strut_vert_spirv, strut_frag_spirv},
                     {{kBindingPositions, kTexels}, {kBindingRest, kTexels}}, sizeof(StrutPush),
                     target_.renderPass(), target_.samples()),
      surfacePipeline_(device, {surface_vert_spirv, surface_frag_spirv},
                       {{kBindingPositions, kTexels}}, sizeof(SurfacePush), target_.renderPass(),
                       target_.samples()) {}

Image StrainRenderer::drawStruts(const DeviceGrid& grid, const Eigen::Isometry3d& worldFromGrid,
                                 const Camera& camera) {
  const TexelView positions = positionTexels(device_, grid);
  const TexelView rest = restTexels(device_, grid);
  const ResourceSet resources(device_, strutPipeline_.setLayout(),
                              {{kBindingPositions, &positions}, {kBindingRest, &rest}});
  StrutPush push = strutPush(grid, viewOf(grid, worldFromGrid, camera, height()));
  return imageOf(target_.render([&](const vk::raii::CommandBuffer& commands) {
    strutPipeline_.bind(commands, resources);
    for (const int count : strutCounts(grid.shape())) {
      if (count > 0) {
        strutPipeline_.draw(commands, push, kVerticesPerQuad * static_cast<uint>(count));
      }
      ++push.direction;
    }
  }));
}

Image StrainRenderer::drawSurface(const DeviceGrid& grid, const Eigen::Isometry3d& worldFromGrid,
                                  const Camera& camera) {
  const TexelView positions = positionTexels(device_, grid);
  const ResourceSet resources(device_, surfacePipeline_.setLayout(),
                              {{kBindingPositions, &positions}});
  const SurfacePush push = surfacePush(grid, viewOf(grid, worldFromGrid, camera, height()));
  return imageOf(target_.render([&](const vk::raii::CommandBuffer& commands) {
    surfacePipeline_.bind(commands, resources);
    surfacePipeline_.draw(commands, push, surfaceVertexCount(push));
  }));
}

Image StrainRenderer::imageOf(std::vector<std::uint8_t> rgba) const {
  return {static_cast<int>(target_.width()), height(), std::move(rgba)};
}

}  // namespace morphgrid
