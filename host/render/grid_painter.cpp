#include "render/grid_painter.h"

#include <cassert>

#include "gpu/command_stream.h"
#include "render/bar_vert.h"
#include "render/ribbon_frag.h"
#include "render/ribbon_vert.h"
#include "render/strut_line_frag.h"
#include "render/strut_line_vert.h"
#include "render/surface_frag.h"
#include "render/surface_vert.h"
#include "render/tube_frag.h"
#include "render/tube_vert.h"

namespace morphgrid {
namespace {

/// One layout for all pipelines, so that a grid's resources suit each of them.
std::vector<ResourceSlot> paintedSlots() {
  constexpr auto kTexels = ResourceType::uniformTexelBuffer;
  return {{kBindingPositions, kTexels},
          {kBindingRest, kTexels},
          {kBindingShares, kTexels},
          {kBindingPrinted, kTexels}};
}

GraphicsPipeline strutPainter(const Device& device, const ShaderPair& shaders, const DrawPass& pass,
                              Primitive primitive) {
  return {device, shaders, paintedSlots(), sizeof(StrutPush), pass, Blending::opaque, primitive};
}

GraphicsPipeline surfacePainter(const Device& device, const ShaderPair& shaders,
                                const DrawPass& pass, Blending blending = Blending::opaque) {
  return {device, shaders, paintedSlots(), sizeof(SurfacePush), pass, blending};
}

/// With the specialisation constant set to true.
ShaderPair with(std::uint32_t constant, ShaderPair shaders) {
  shaders.constants.resize(constant + 1, 0);
  shaders.constants[constant] = 1;
  return shaders;
}

uint verticesPerStrut(StrutStyle style, bool isFrame) {
  switch (style) {
    case StrutStyle::lines:
      return kVerticesPerLine;
    case StrutStyle::ribbons:
      return kVerticesPerQuad;
    case StrutStyle::tubes:
      break;
  }
  return isFrame ? kVerticesPerBar : kVerticesPerTube;
}

/// A texel a vertex: the shares of its struts to +u, +v and +w, and its column's.
std::vector<glm::vec4> shareTexels(const StrutValues& struts, const Eigen::VectorXd& columns) {
  assert(columns.size() <= static_cast<Eigen::Index>(struts.u.size()));
  std::vector<glm::vec4> texels(struts.u.size());
  for (std::size_t n = 0; n < texels.size(); ++n) {
    const auto place = static_cast<Eigen::Index>(n);
    texels[n] = {struts.u[n], struts.v[n], struts.w[n],
                 place < columns.size() ? columns[place] : 0};
  }
  return texels;
}

}  // namespace

StrutShares::StrutShares(const Device& device, const StrutValues& struts,
                         const Eigen::VectorXd& columns)
    : buffer_(device, struts.u.size() * sizeof(glm::vec4),
              BufferUsage::uniformTexelBuffer | BufferUsage::transferDst, MemoryKind::device),
      texels_(device, buffer_, TexelFormat::float4) {
  upload(device, buffer_, shareTexels(struts, columns));
}

GridResources::GridResources(const Device& device, const DeviceGrid& grid,
                             const StrutShares* shares)
    : grid_(grid),
      hasShares_(shares != nullptr),
      positions_(positionTexels(device, grid)),
      previousPositions_(texelsOf(device, grid.previousPositions())),
      rest_(restTexels(device, grid)),
      unread_(stiffnessTexels(device, grid)),
      printed_(grid.isFrame() ? std::optional(printedTexels(device, grid)) : std::nullopt),
      shares_(shares ? &shares->texels() : &unread_),
      layout_(device, paintedSlots(), ShaderStage::vertex),
      newestFirst_(setFor(device, positions_)),
      newestSecond_(setFor(device, previousPositions_)) {}

ResourceSet GridResources::setFor(const Device& device, const TexelView& positions) const {
  return {device,
          layout_,
          {{kBindingPositions, &positions},
           {kBindingRest, &rest_},
           {kBindingShares, shares_},
           {kBindingPrinted, printed_ ? &*printed_ : &unread_}}};
}

GridPainter::Painter GridPainter::strutPainters(const Device& device, const DrawPass& pass,
                                                const ShaderPair& shaders, Primitive primitive) {
  return {strutPainter(device, shaders, pass, primitive),
          strutPainter(device, with(kConstantShowsShares, shaders), pass, primitive)};
}

GridPainter::GridPainter(const Device& device, const DrawPass& pass)
    : struts_{strutPainters(device, pass, {strut_line_vert_spirv, strut_line_frag_spirv},
                            Primitive::lines),
              strutPainters(device, pass, {ribbon_vert_spirv, ribbon_frag_spirv},
                            Primitive::triangles),
              strutPainters(device, pass, {tube_vert_spirv, tube_frag_spirv},
                            Primitive::frontTriangles)},
      bars_(strutPainters(device, pass, {bar_vert_spirv, tube_frag_spirv},
                          Primitive::frontTriangles)),
      surface_{
          surfacePainter(device, {surface_vert_spirv, surface_frag_spirv}, pass),
          surfacePainter(
              device, with(kConstantShowsShares, {surface_vert_spirv, surface_frag_spirv}), pass)},
      veil_(surfacePainter(device, with(kConstantIsVeil, {surface_vert_spirv, surface_frag_spirv}),
                           pass, Blending::translucent)) {}

void GridPainter::draw(const CommandBuffer& commands, const GridResources& resources,
                       const GridLook& look, const LocalView& view) const {
  const ResourceSet& set =
      resources.grid_.newestIsFirst() ? resources.newestFirst_ : resources.newestSecond_;
  if (look.isSurface) {
    drawSurface(commands, resources, set, look, view);
  } else {
    drawStruts(commands, resources, set, look, view);
  }
}

void GridPainter::drawSurface(const CommandBuffer& commands, const GridResources& resources,
                              const ResourceSet& set, const GridLook& look,
                              const LocalView& view) const {
  const GraphicsPipeline& opaque = resources.hasShares_ ? surface_.shares : surface_.plain;
  const GraphicsPipeline& pipeline = look.isVeil ? veil_ : opaque;
  const SurfacePush push = surfacePush(resources.grid_, view, look.mostQuads);
  pipeline.bind(commands, set);
  pipeline.draw(commands, push, surfaceVertexCount(push));
}

const GridPainter::Painter& GridPainter::painterOf(StrutStyle style, bool isFrame) const {
  return isFrame && style == StrutStyle::tubes ? bars_ : struts_[static_cast<std::size_t>(style)];
}

void GridPainter::drawStruts(const CommandBuffer& commands, const GridResources& resources,
                             const ResourceSet& set, const GridLook& look,
                             const LocalView& view) const {
  const bool isFrame = resources.grid_.isFrame();
  const Painter& painter = painterOf(look.style, isFrame);
  const GraphicsPipeline& pipeline = resources.hasShares_ ? painter.shares : painter.plain;
  GridShape drawn = resources.grid_.shape();
  if (look.style == StrutStyle::lines) {
    const ivec2 lattice = thinnedSize(sizeOf(drawn), look.stride);
    drawn.verticesU = lattice.x;
    drawn.verticesV = lattice.y;
  }
  pipeline.bind(commands, set);
  for (int direction = 0; direction < 3; ++direction) {
    const auto count =
        static_cast<uint>(drawn.strutCount(static_cast<Strut::Direction>(direction)));
    if (look.directions[direction] && count > 0) {
      StrutPush push = strutPush(resources.grid_, view, direction);
      push.stride = look.style == StrutStyle::lines ? look.stride : 1;
      pipeline.draw(commands, push, count * verticesPerStrut(look.style, isFrame));
    }
  }
}

}  // namespace morphgrid
