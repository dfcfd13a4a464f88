#pragma once
#include <map>

#include "gpu/draw_pass.h"
#include "render/draw_sampling.h"
#include "render/grid_painter.h"
#include "view/detail_governor.h"
#include "view/session.h"

namespace morphgrid {

/// A grid as it is to be drawn.
struct DrawnGrid {
  ShownGrid shown;
  GridLook look;
  std::shared_ptr<const StrutShares> shares;  ///< Null: strain.
};

/// The part of the window that shows the scene, in pixels.
struct SceneArea {
  int left = 0;
  int top = 0;
  int width = 1;
  int height = 1;

  double aspect() const { return static_cast<double>(width) / height; }
};

/// Draws grids into the images of a window.
class SceneView {
 public:
  /// format: of the swapchain. Keeps a reference. Throws DeviceError when the device refuses.
  SceneView(const Device& device, ColorFormat format);

  /// New images to draw into: of a swapchain of this size.
  void setImages(PixelSize size, const std::vector<VkImageView>& images);

  /// Draws into image `image`, which is in eColorAttachmentOptimal afterwards; sampling may be
  /// null. To be called when the last picture has been drawn: what only that one needed is let go.
  void record(const CommandBuffer& commands, std::size_t image, int samples,
              const std::vector<DrawnGrid>& grids,
              const std::shared_ptr<const MeshSampling>& sampling, const Camera& camera,
              const SceneArea& area);

 private:
  /// The same for a number of samples a pixel.
  struct Style {
    DrawPass pass;
    GridPainter painter;
    std::optional<Canvas> canvas;
  };
  struct Held {
    std::shared_ptr<const DeviceGrid> grid;
    std::shared_ptr<const StrutShares> shares;
    std::unique_ptr<GridResources> resources;
    bool isUsed;
  };

  Style& styleOf(int samples);
  const Canvas& canvasOf(Style& style);
  const SamplingDrawing& drawingOf(const std::shared_ptr<const MeshSampling>& sampling,
                                   const Style& style);
  const GridResources& resourcesOf(const DrawnGrid& drawn);
  void letGo();

  const Device& device_;
  ColorFormat format_;
  std::map<int, std::unique_ptr<Style>> styles_;
  std::vector<Held> held_;
  std::shared_ptr<const MeshSampling> sampling_;
  std::unique_ptr<SamplingDrawing> samplingDrawing_;  ///< Draws sampling_, in the style drawn last.
  const Style* samplingStyle_ = nullptr;
  PixelSize size_;
  std::vector<VkImageView> images_;
};

}  // namespace morphgrid
