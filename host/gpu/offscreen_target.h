#pragma once
#include <functional>
#include <optional>

#include "gpu/attachment.h"
#include "gpu/command_stream.h"

namespace morphgrid {

/// Colour and depth of a picture that is drawn off screen and read back.
class OffscreenTarget {
 public:
  /// width, height > 0, in pixels. Takes as many samples a pixel as the device has, up to
  /// `wantedSamples` (1 or 4). Throws DeviceError when the device cannot draw such an image.
  OffscreenTarget(const Device& device, std::uint32_t width, std::uint32_t height,
                  std::uint32_t wantedSamples);

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }
  vk::RenderPass renderPass() const { return *renderPass_; }
  vk::SampleCountFlagBits samples() const { return samples_; }

  /// Clears to white, records `draw` inside the render pass, with shaders seeing all that was
  /// written before, and waits. Returns height x width x 4 bytes, RGBA, from the top.
  std::vector<std::uint8_t> render(const std::function<void(const vk::raii::CommandBuffer&)>& draw);

 private:
  vk::raii::Framebuffer createFramebuffer(const Device& device) const;
  void recordPass(const std::function<void(const vk::raii::CommandBuffer&)>& draw);
  void recordReadBack();

  std::uint32_t width_;
  std::uint32_t height_;
  vk::SampleCountFlagBits samples_;
  vk::Format depthFormat_;
  std::optional<Attachment> multisampled_;  ///< Only where a pixel has several samples.
  Attachment color_;
  Attachment depth_;
  vk::raii::RenderPass renderPass_;
  vk::raii::Framebuffer framebuffer_;
  Buffer pixels_;
  CommandStream stream_;
};

}  // namespace morphgrid
