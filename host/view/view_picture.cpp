#include "view/view_picture.h"

#include "gpu/offscreen_target.h"
#include "render/picture.h"

namespace morphgrid {
namespace {

constexpr int kPictureSamples = 4;  // Samples a pixel.

Image drawOffScreen(const Device& device, const DrawList& list, const SceneSize& size,
                    const Camera& camera) {
  OffscreenTarget target(device, static_cast<std::uint32_t>(size.width),
                         static_cast<std::uint32_t>(size.height), kPictureSamples);
  const GridPainter painter(device, target.pass());
  std::vector<std::unique_ptr<GridResources>> resources;
  std::optional<SamplingDrawing> sampling;
  if (const auto& shown = list.sampling()) {
    sampling.emplace(device, shown->mesh, shown->hits, target.pass());
  }
  const auto draw = [&](const CommandBuffer& commands) {
    if (sampling) {
      sampling->draw(commands, camera, size.height);
    }
    for (const DrawnGrid& drawn : list.grids()) {
      const DeviceGrid& grid = *drawn.shown.onDevice;
      GridLook look = drawn.look;
      look.style = list.pictureStyle();
      look.stride = 1;
      look.mostQuads.reset();
      resources.push_back(std::make_unique<GridResources>(device, grid, drawn.shares.get()));
      painter.draw(commands, *resources.back(), look,
                   viewOf(grid, drawn.shown.worldFromGrid, camera, size.height));
    }
  };
  return {size.width, size.height, target.render(draw)};
}

}  // namespace

void saveViewPicture(const std::filesystem::path& file, const Device& device, const DrawList& list,
                     const std::string& caption,
                     const std::function<Camera(double aspect)>& camera) {
  PictureOptions options;
  options.caption = caption;
  options.legend = list.legend();
  const SceneSize size = sceneSize(options);
  writePng(file, composePicture(drawOffScreen(device, list, size, camera(size.aspect())), options));
}

}  // namespace morphgrid
