#include "render/grid_painter.h"

#include "gpu/command_stream.h"
#include "render/strut_frag.h"
#include "render/strut_line_frag.h"
#include "render/strut_line_share_vert.h"
#include "render/strut_line_vert.h"
#include "render/strut_share_frag.h"
#include "render/strut_share_vert.h"
#include "render/strut_vert.h"
#include "render/surface_frag.h"
#include "render/surface_veil_frag.h"
#include "render/surface_vert.h"
#include "shared/solver_types.h"

namespace morphgrid {
namespace {

/// One layout for all pipelines, so that a grid's resources suit each of them.
std::vector<ResourceSlot> paintedSlots() {
  constexpr auto kTexels = vk::DescriptorType::eUniformTexelBuffer;
  return {{kBindingPositions, kTexels}, {kBindingRest, kTexels}, {kBindingShares, kTexels}};
}

GraphicsPipeline strutPainter(const Device& device, const ShaderPair& shaders,
                              vk::RenderPass renderPass, vk::SampleCountFlagBits samples,
                              Primitive primitive) {
  return {device,     shaders, paintedSlots(),   sizeof(StrutPush),
          renderPass, samples, Blending::opaque, primitive};
}

GraphicsPipeline surfacePainter(const Device& device, ShaderCode fragment,
                                vk::RenderPass renderPass, vk::SampleCountFlagBits samples,
                                Blending blending) {
  return {device,         {surface_vert_spirv, fragment},
          paintedSlots(), sizeof(SurfacePush),
          renderPass,     samples,
          blending};
}

/// A column a vertex: the shares of its struts to +u, +v and +w, and nothing.
std::vector<glm::vec4> shareColumns(const StrutValues& shares) {
  std::vector<glm::vec4> columns(shares.u.size());
  for (std::size_t n = 0; n < columns.size(); ++n) {
    columns[n] = {shares.u[n], shares.v[n], shares.w[n], 0};
  }
  return columns;
}

/// Of `count` vertices every stride-th, and the last.
int drawnVertices(int count, int stride) { return (count - 2) / stride + 2; }

}  // namespace

StrutShares::StrutShares(const Device& device, const StrutValues& shares)
    : buffer_(device, shares.u.size() * sizeof(glm::vec4),
              vk::BufferUsageFlagBits::eUniformTexelBuffer | vk::BufferUsageFlagBits::eTransferDst,
              MemoryKind::device),
      texels_(device, buffer_, vk::Format::eR32G32B32A32Sfloat, sizeof(glm::vec4)) {
  upload(device, buffer_, shareColumns(shares));
}

GridResources::GridResources(const Device& device, const DeviceGrid& grid,
                             const StrutShares* shares)
    : grid_(grid),
      hasShares_(shares != nullptr),
      positions_(positionTexels(device, grid)),
      previousPositions_(texelsOf(device, grid.previousPositions())),
      rest_(restTexels(device, grid)),
      shares_(shares ? &shares->texels() : &rest_),  // Unread, but a set has no gaps.
      layout_(createSetLayout(device, paintedSlots(), vk::ShaderStageFlagBits::eVertex)),
      newestFirst_(setFor(device, positions_)),
      newestSecond_(setFor(device, previousPositions_)) {}

ResourceSet GridResources::setFor(const Device& device, const TexelView& positions) const {
  return {device,
          *layout_,
          {{kBindingPositions, &positions}, {kBindingRest, &rest_}, {kBindingShares, shares_}}};
}

GridPainter::GridPainter(const Device& device, vk::RenderPass renderPass,
                         vk::SampleCountFlagBits samples)
    : strainRibbons_(strutPainter(device, {strut_vert_spirv, strut_frag_spirv}, renderPass, samples,
                                  Primitive::triangles)),
      shareRibbons_(strutPainter(device, {strut_share_vert_spirv, strut_share_frag_spirv},
                                 renderPass, samples, Primitive::triangles)),
      strainLines_(strutPainter(device, {strut_line_vert_spirv, strut_line_frag_spirv}, renderPass,
                                samples, Primitive::lines)),
      shareLines_(strutPainter(device, {strut_line_share_vert_spirv, strut_line_frag_spirv},
                               renderPass, samples, Primitive::lines)),
      surface_(surfacePainter(device, surface_frag_spirv, renderPass, samples, Blending::opaque)),
      veil_(surfacePainter(device, surface_veil_frag_spirv, renderPass, samples,
                           Blending::translucent)) {}

void GridPainter::draw(const vk::raii::CommandBuffer& commands, const GridResources& resources,
                       const GridLook& look, const LocalView& view) const {
  const DeviceGrid& grid = resources.grid_;
  const ResourceSet& set = grid.newestIsFirst() ? resources.newestFirst_ : resources.newestSecond_;
  if (look.isSurface) {
    const GraphicsPipeline& pipeline = look.isVeil ? veil_ : surface_;
    const SurfacePush push = surfacePush(grid, view, look.mostQuads);
    pipeline.bind(commands, set);
    pipeline.draw(commands, push, surfaceVertexCount(push));
    return;
  }
  const bool ribbons = look.style == StrutStyle::ribbons;
  const GraphicsPipeline& pipeline = resources.hasShares_
                                         ? (ribbons ? shareRibbons_ : shareLines_)
                                         : (ribbons ? strainRibbons_ : strainLines_);
  pipeline.bind(commands, set);
  drawStruts(commands, grid, pipeline, look, view);
}

void GridPainter::drawStruts(const vk::raii::CommandBuffer& commands, const DeviceGrid& grid,
                             const GraphicsPipeline& pipeline, const GridLook& look,
                             const LocalView& view) const {
  const bool ribbons = look.style == StrutStyle::ribbons;
  StrutPush push = strutPush(grid, view);
  GridShape drawn = grid.shape();
  if (!ribbons) {
    push.stride = look.stride;
    drawn.verticesU = drawnVertices(drawn.verticesU, look.stride);
    drawn.verticesV = drawnVertices(drawn.verticesV, look.stride);
  }
  const std::array<int, 3> counts = strutCounts(drawn);
  for (push.direction = 0; push.direction < 3; ++push.direction) {
    const auto count = static_cast<uint>(counts[push.direction]);
    if (look.directions[push.direction] && count > 0) {
      pipeline.draw(commands, push, count * (ribbons ? kVerticesPerQuad : kVerticesPerLine));
    }
  }
}

}  // namespace morphgrid
