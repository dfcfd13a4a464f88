#include "render/strain_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "render/strut_frag.h"
#include "render/strut_vert.h"
#include "render/surface_frag.h"
#include "render/surface_vert.h"
#include "shared/render_types.h"
#include "shared/solver_types.h"

namespace morphgrid {
namespace {

constexpr double kStrutHalfWidth = 0.042;    // Spacings.
constexpr double kLargestHalfWidth = 0.012;  // Of the grid's longer side: few cells stay slender.
constexpr int kMostSurfaceQuads = 30000;     // The surface is refined up to about this many.
constexpr int kFinestRefinement = 16;
constexpr int kMostIsolines = 50;  // Along u, and along v.

constexpr auto kTexels = vk::DescriptorType::eUniformTexelBuffer;

TexelView texelsOf(const Device& device, const Buffer& buffer) {
  return {device, buffer, vk::Format::eR32G32B32A32Sint, sizeof(ivec4)};
}

/// Local coordinates: spacings about the grid's fixed-point zero.
glm::dmat4 worldFromLocal(const DeviceGrid& grid, const Eigen::Isometry3d& worldFromGrid) {
  const Eigen::Matrix4d& rigid = worldFromGrid.matrix();
  const Eigen::Vector3d& origin = grid.origin();
  const glm::dmat4 moved =
      glm::translate(glm::make_mat4(rigid.data()), {origin.x(), origin.y(), origin.z()});
  return glm::scale(moved, glm::dvec3(grid.spacing()));
}

double chooseHalfWidth(const GridShape& shape) {
  const double longerSide = std::max(shape.verticesU, shape.verticesV) - 1;
  return std::min(kStrutHalfWidth, kLargestHalfWidth * longerSide);
}

StrutPush strutPush(const DeviceGrid& grid, const LocalView& view) {
  const GridShape& shape = grid.shape();
  StrutPush push{};
  push.clipFromLocal = view.clipFromLocal;
  push.eye = view.eye;
  push.halfWidth = static_cast<float>(chooseHalfWidth(shape));
  push.towardsLight = view.towardsLight;
  push.resolution = static_cast<float>(grid.resolution());
  push.verticesU = shape.verticesU;
  push.verticesV = shape.verticesV;
  push.layers = shape.layers;
  push.restResolution = static_cast<float>(grid.restResolution());
  push.pixelSize = view.pixelSize;
  return push;
}

/// Struts to +u, +v, +w.
std::array<int, 3> strutCounts(const GridShape& shape) {
  return {(shape.verticesU - 1) * shape.verticesV * shape.layers,
          shape.verticesU * (shape.verticesV - 1) * shape.layers,
          shape.layerVertexCount() * (shape.layers - 1)};
}

int chooseRefinement(const GridShape& shape) {
  const double cells = static_cast<double>(shape.verticesU - 1) * (shape.verticesV - 1);
  return std::clamp(static_cast<int>(std::sqrt(kMostSurfaceQuads / cells)), 1, kFinestRefinement);
}

SurfacePush surfacePush(const DeviceGrid& grid, const LocalView& view) {
  const GridShape& shape = grid.shape();
  SurfacePush push{};
  push.clipFromLocal = view.clipFromLocal;
  push.eye = view.eye;
  push.resolution = static_cast<float>(grid.resolution());
  push.towardsLight = view.towardsLight;
  push.refine = chooseRefinement(shape);
  push.verticesU = shape.verticesU;
  push.verticesV = shape.verticesV;
  push.layers = shape.layers;
  push.isolineStride = 1 + std::max(shape.verticesU, shape.verticesV) / kMostIsolines;
  return push;
}

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
  const TexelView positions = texelsOf(device_, grid.positions());
  const TexelView rest = texelsOf(device_, grid.rest());
  const ResourceSet resources(device_, strutPipeline_.setLayout(),
                              {{kBindingPositions, &positions}, {kBindingRest, &rest}});
  StrutPush push = strutPush(grid, viewOf(grid, worldFromGrid, camera));
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
  const TexelView positions = texelsOf(device_, grid.positions());
  const ResourceSet resources(device_, surfacePipeline_.setLayout(),
                              {{kBindingPositions, &positions}});
  const SurfacePush push = surfacePush(grid, viewOf(grid, worldFromGrid, camera));
  const int quads = (push.verticesU - 1) * (push.verticesV - 1) * push.refine * push.refine;
  return imageOf(target_.render([&](const vk::raii::CommandBuffer& commands) {
    surfacePipeline_.bind(commands, resources);
    surfacePipeline_.draw(commands, push, kVerticesPerQuad * static_cast<uint>(quads));
  }));
}

LocalView StrainRenderer::viewOf(const DeviceGrid& grid, const Eigen::Isometry3d& worldFromGrid,
                                 const Camera& camera) const {
  return localView(worldFromLocal(grid, worldFromGrid), camera, static_cast<int>(target_.height()));
}

Image StrainRenderer::imageOf(std::vector<std::uint8_t> rgba) const {
  return {static_cast<int>(target_.width()), static_cast<int>(target_.height()), std::move(rgba)};
}

}  // namespace morphgrid
