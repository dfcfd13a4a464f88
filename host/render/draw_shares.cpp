#include "render/draw_shares.h"

#include <cassert>

#include "gpu/graphics_pipeline.h"
#include "gpu/offscreen_target.h"
#include "render/grid_drawing.h"
#include "render/strut_share_frag.h"
#include "render/strut_share_vert.h"
#include "render/surface_share_frag.h"
#include "render/surface_share_vert.h"
#include "render/surface_veil_frag.h"
#include "render/surface_vert.h"
#include "shared/solver_types.h"

namespace morphgrid {
namespace {

Buffer uploadTexels(const Device& device, const Eigen::MatrixXf& texels) {
  const vk::DeviceSize bytes = texels.size() * sizeof(float);
  Buffer buffer(
      device, bytes,
      vk::BufferUsageFlagBits::eUniformTexelBuffer | vk::BufferUsageFlagBits::eTransferDst,
      MemoryKind::device);
  uploadBytes(device, buffer, texels.data(), bytes);
  return buffer;
}

/// A column a vertex: the shares of its struts to +u, +v and +w, and nothing.
Eigen::MatrixXf columnsOf(const StrutValues& shares) {
  const auto row = [](const std::vector<double>& values) {
    return Eigen::Map<const Eigen::RowVectorXd>(values.data(),
                                                static_cast<Eigen::Index>(values.size()))
        .cast<float>();
  };
  Eigen::MatrixXf columns = Eigen::MatrixXf::Zero(4, static_cast<Eigen::Index>(shares.u.size()));
  columns.row(0) = row(shares.u);
  columns.row(1) = row(shares.v);
  columns.row(2) = row(shares.w);
  return columns;
}

/// A pair of shaders with the texels that they read.
struct SheetLayer {
  GraphicsPipeline pipeline;
  ResourceSet resources;

  SheetLayer(const Device& device, const OffscreenTarget& target, const ShaderPair& shaders,
             const std::vector<KernelResource>& texels, std::size_t pushBytes,
             Blending blending = Blending::opaque)
      : pipeline(device, shaders, slotsOf(texels), static_cast<uint>(pushBytes),
                 target.renderPass(), target.samples(), blending),
        resources(device, pipeline.setLayout(), texels) {}
};

OffscreenTarget createTarget(const Device& device, int width, int height, int samples) {
  return {device, static_cast<uint>(width), static_cast<uint>(height), static_cast<uint>(samples)};
}

}  // namespace

Image drawStrutShares(const Device& device, const DeviceGrid& grid, const StrutValues& shares,
                      const Camera& camera, int width, int height, int samples) {
  assert(static_cast<int>(shares.u.size()) == grid.shape().vertexCount());
  const Buffer shareBuffer = uploadTexels(device, columnsOf(shares));
  const TexelView positions = positionTexels(device, grid);
  const TexelView shareTexels(device, shareBuffer, vk::Format::eR32G32B32A32Sfloat, sizeof(vec4));
  OffscreenTarget target = createTarget(device, width, height, samples);
  const SheetLayer layer(device, target, {strut_share_vert_spirv, strut_share_frag_spirv},
                         {{kBindingPositions, &positions}, {kBindingShares, &shareTexels}},
                         sizeof(StrutPush));
  const std::array<int, 3> counts = strutCounts(grid.shape());
  StrutPush push = strutPush(grid, viewOf(grid, Eigen::Isometry3d::Identity(), camera, height));
  return {width, height, target.render([&](const vk::raii::CommandBuffer& commands) {
            layer.pipeline.bind(commands, layer.resources);
            layer.pipeline.draw(commands, push, kVerticesPerQuad * static_cast<uint>(counts[0]));
            push.direction = 1;
            layer.pipeline.draw(commands, push, kVerticesPerQuad * static_cast<uint>(counts[1]));
          })};
}

Image drawSurfaceShares(const Device& device, const PlacedGrid& surface,
                        const Eigen::VectorXd& shares, const PlacedGrid& veil, const Camera& camera,
                        int width, int height, int samples) {
  assert(shares.size() == surface.grid.shape().layerVertexCount());
  const Buffer shareBuffer = uploadTexels(device, shares.cast<float>());
  const TexelView positions = positionTexels(device, surface.grid);
  const TexelView shareTexels(device, shareBuffer, vk::Format::eR32Sfloat, sizeof(float));
  const TexelView veilPositions = positionTexels(device, veil.grid);
  OffscreenTarget target = createTarget(device, width, height, samples);
  const SheetLayer surfaceLayer(
      device, target, {surface_share_vert_spirv, surface_share_frag_spirv},
      {{kBindingPositions, &positions}, {kBindingShares, &shareTexels}}, sizeof(SurfacePush));
  const SheetLayer veilLayer(device, target, {surface_vert_spirv, surface_veil_frag_spirv},
                             {{kBindingPositions, &veilPositions}}, sizeof(SurfacePush),
                             Blending::translucent);
  const auto pushOf = [&](const PlacedGrid& placed) {
    return surfacePush(placed.grid, viewOf(placed.grid, placed.worldFromGrid, camera, height));
  };
  return {width, height, target.render([&](const vk::raii::CommandBuffer& commands) {
            for (const auto& [layer, push] :
                 {std::pair(&surfaceLayer, pushOf(surface)), std::pair(&veilLayer, pushOf(veil))}) {
              layer->pipeline.bind(commands, layer->resources);
              layer->pipeline.draw(commands, push, surfaceVertexCount(push));
            }
          })};
}

}  // namespace morphgrid
