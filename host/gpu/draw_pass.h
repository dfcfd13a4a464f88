#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "gpu/device.h"
#include "gpu/pixel_size.h"

namespace morphgrid {

class CommandBuffer;  // gpu/vulkan_commands.h

/// The format of images that are drawn into: 8 bits a component, as the shaders write them.
enum class ColorFormat { rgba8, bgra8 };

/// What is done with an image when it has been drawn into.
enum class NextUse { copied, drawnOver };

struct DrawPassOptions {
  ColorFormat format;         ///< The format of the images that are drawn into.
  std::uint32_t samples = 1;  ///< Samples a pixel, 1 or 4, where the device has as many.
  NextUse nextUse;            ///< What the images are used for next.
};

/// How pictures are drawn: on white, with a depth test. Shaders see all that was written before,
/// and what is written later waits for them.
class DrawPass {
 public:
  struct Handles;  // gpu/vulkan_pass.h

  /// Throws DeviceError when the device refuses.
  DrawPass(const Device& device, const DrawPassOptions& options);
  DrawPass(DrawPass&&) = default;
  DrawPass& operator=(DrawPass&&) = default;

  /// How many a pixel has.
  std::uint32_t samples() const;
  const Handles& handles() const { return *handles_; }

 private:
  std::shared_ptr<const Handles> handles_;
};

/// A part of an image, in pixels.
struct Viewport {
  float left;
  float top;
  float width;
  float height;
};

/// Records where draws go, inside a pass.
void setViewport(const CommandBuffer& commands, const Viewport& viewport);

/// Images of one size to draw into by a pass, with what it needs beside them.
class Canvas {
 public:
  /// size > 0; images: of this size and the pass's format; they and the pass must outlive it.
  /// Throws DeviceError when the device cannot draw such an image.
  Canvas(const Device& device, const DrawPass& pass, PixelSize size,
         const std::vector<VkImageView>& images);
  Canvas(Canvas&&) = default;
  Canvas& operator=(Canvas&&) = default;

  PixelSize size() const { return size_; }

  /// Records the pass, `draw` inside it, into the image of this index.
  void record(const CommandBuffer& commands, std::size_t image,
              const std::function<void(const CommandBuffer&)>& draw) const;

 private:
  struct Handles;

  PixelSize size_;
  std::shared_ptr<const Handles> handles_;
};

}  // namespace morphgrid
