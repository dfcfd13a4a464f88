#include "view/scene_view.h"

#include <algorithm>

namespace morphgrid {

SceneView::SceneView(const Device& device, ColorFormat format) : device_(device), format_(format) {}

void SceneView::setImages(PixelSize size, const std::vector<VkImageView>& images) {
  size_ = size;
  images_ = images;
  for (auto& [samples, style] : styles_) {
    style->canvas.reset();
  }
}

SceneView::Style& SceneView::styleOf(int samples) {
  std::unique_ptr<Style>& style = styles_[samples];
  if (!style) {
    DrawPass pass(device_, {format_, static_cast<std::uint32_t>(samples), NextUse::drawnOver});
    GridPainter painter(device_, pass);
    style = std::make_unique<Style>(Style{std::move(pass), std::move(painter), std::nullopt});
  }
  return *style;
}

const Canvas& SceneView::canvasOf(Style& style) {
  if (!style.canvas) {
    style.canvas.emplace(device_, style.pass, size_, images_);
  }
  return *style.canvas;
}

const GridResources& SceneView::resourcesOf(const DrawnGrid& drawn) {
  const auto found = std::find_if(held_.begin(), held_.end(), [&](const Held& held) {
    return held.grid == drawn.shown.onDevice && held.shares == drawn.shares;
  });
  if (found != held_.end()) {
    found->isUsed = true;
    return *found->resources;
  }
  held_.push_back(
      {drawn.shown.onDevice, drawn.shares,
       std::make_unique<GridResources>(device_, *drawn.shown.onDevice, drawn.shares.get()), true});
  return *held_.back().resources;
}

const SamplingDrawing& SceneView::drawingOf(const std::shared_ptr<const MeshSampling>& sampling,
                                            const Style& style) {
  if (sampling_ != sampling || samplingStyle_ != &style) {
    samplingDrawing_ =
        std::make_unique<SamplingDrawing>(device_, sampling->mesh, sampling->hits, style.pass);
    sampling_ = sampling;
    samplingStyle_ = &style;
  }
  return *samplingDrawing_;
}

void SceneView::letGo() {
  std::erase_if(held_, [](const Held& held) { return !held.isUsed; });
  for (Held& held : held_) {
    held.isUsed = false;
  }
}

void SceneView::record(const CommandBuffer& commands, std::size_t image, int samples,
                       const std::vector<DrawnGrid>& grids,
                       const std::shared_ptr<const MeshSampling>& sampling, const Camera& camera,
                       const SceneArea& area) {
  letGo();
  Style& style = styleOf(samples);
  canvasOf(style).record(commands, image, [&](const CommandBuffer& pass) {
    setViewport(pass, {static_cast<float>(area.left), static_cast<float>(area.top),
                       static_cast<float>(area.width), static_cast<float>(area.height)});
    if (sampling) {
      drawingOf(sampling, style).draw(pass, camera, area.height);
    }
    for (const DrawnGrid& drawn : grids) {
      const DeviceGrid& grid = *drawn.shown.onDevice;
      style.painter.draw(pass, resourcesOf(drawn), drawn.look,
                         viewOf(grid, drawn.shown.worldFromGrid, camera, area.height));
    }
  });
}

}  // namespace morphgrid
