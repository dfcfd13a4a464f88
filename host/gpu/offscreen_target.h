#pragma once
#include <functional>

#include "gpu/command_stream.h"
#include "gpu/draw_pass.h"

namespace morphgrid {

class Attachment;  // gpu/vulkan_attachment.h

/// Colour and depth of a picture that is drawn off screen and read back.
class OffscreenTarget {
 public:
  /// width, height > 0, in pixels. Takes as many samples a pixel as the device has, up to
  /// `wantedSamples` (1 or 4). Throws DeviceError when the device cannot draw such an image.
  OffscreenTarget(const Device& device, std::uint32_t width, std::uint32_t height,
                  std::uint32_t wantedSamples);

  PixelSize size() const { return canvas_.size(); }
  const DrawPass& pass() const { return pass_; }

  /// Clears to white, records `draw` inside the render pass, with shaders seeing all that was
  /// written before, and waits. Returns height x width x 4 bytes, RGBA, from the top.
  std::vector<std::uint8_t> render(const std::function<void(const CommandBuffer&)>& draw);

 private:
  void recordReadBack();

  DrawPass pass_;
  std::shared_ptr<const Attachment> color_;
  Canvas canvas_;
  Buffer pixels_;
  CommandStream stream_;
};

}  // namespace morphgrid
