#pragma once
#include <array>
#include <optional>

#include "gpu/graphics_pipeline.h"
#include "grid/strut_grid.h"
#include "render/grid_drawing.h"

namespace morphgrid {

/// A number for each strut of a grid, and for each column, in the device's memory, for
/// shareColor().
class StrutShares {
 public:
  /// struts: of a grid of vertexCount vertices. columns: layerVertexCount, which surfaces show;
  /// none: 0. Throws DeviceError when memory runs out.
  StrutShares(const Device& device, const StrutValues& struts, const Eigen::VectorXd& columns = {});

  const TexelView& texels() const { return texels_; }

 private:
  Buffer buffer_;
  TexelView texels_;
};

enum class StrutStyle {
  lines,    ///< A pixel wide.
  ribbons,  ///< Facing the eye, shaded like rods.
  tubes,    ///< Prisms, from any side and up close what they look like; a frame's are its bars.
};

/// How struts are drawn in pictures: of a frame one sees the bars.
inline StrutStyle pictureStyleOf(const DeviceGrid& grid) {
  return grid.isFrame() ? StrutStyle::tubes : StrutStyle::ribbons;
}

/// What of a grid is drawn, and how.
struct GridLook {
  bool isSurface = false;  ///< The middle layer's surface instead of the struts.
  bool isVeil = false;     ///< Whether the surface is translucent, without colours.
  /// A surface has about so many at most; none: as surfacePush() chooses.
  std::optional<int> mostQuads;
  StrutStyle style = StrutStyle::ribbons;
  int stride = 1;  ///< Lines join every n-th vertex along u and v.
  std::array<bool, 3> directions = {true, true, true};  ///< Whether struts to +u, +v, +w are drawn.
};

/// What shaders read of a grid. Must live until the device has drawn.
class GridResources {
 public:
  /// shares may be null: struts are coloured by strain then, surfaces by their sides. Keeps
  /// references. Throws DeviceError
  /// when the grid exceeds the device's limits.
  GridResources(const Device& device, const DeviceGrid& grid, const StrutShares* shares = nullptr);

 private:
  friend class GridPainter;

  ResourceSet setFor(const Device& device, const TexelView& positions) const;

  const DeviceGrid& grid_;
  bool hasShares_;
  TexelView positions_;
  TexelView previousPositions_;
  TexelView rest_;
  TexelView unread_;                  ///< A set has no gaps.
  std::optional<TexelView> printed_;  ///< Of a frame.
  const TexelView* shares_;
  ResourceLayout layout_;
  ResourceSet newestFirst_;
  ResourceSet newestSecond_;
};

/// Records draws of grids, from the solver's own buffers in their newest state, into a pass.
class GridPainter {
 public:
  /// Throws DeviceError when the device refuses.
  GridPainter(const Device& device, const DrawPass& pass);

  /// To be called inside the pass. view: of viewOf() for this grid.
  void draw(const CommandBuffer& commands, const GridResources& resources, const GridLook& look,
            const LocalView& view) const;

 private:
  /// A look, in the colours of strains or sides, and in those of shares.
  struct Painter {
    GraphicsPipeline plain;
    GraphicsPipeline shares;
  };

  static Painter strutPainters(const Device& device, const DrawPass& pass,
                               const ShaderPair& shaders, Primitive primitive);
  const Painter& painterOf(StrutStyle style, bool isFrame) const;
  void drawStruts(const CommandBuffer& commands, const GridResources& resources,
                  const ResourceSet& set, const GridLook& look, const LocalView& view) const;
  void drawSurface(const CommandBuffer& commands, const GridResources& resources,
                   const ResourceSet& set, const GridLook& look, const LocalView& view) const;

  std::array<Painter, 3> struts_;  ///< Indexed by StrutStyle.
  Painter bars_;                   ///< For StrutStyle::tubes, of frames.
  Painter surface_;
  GraphicsPipeline veil_;
};

}  // namespace morphgrid
