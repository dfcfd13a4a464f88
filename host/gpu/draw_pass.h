#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "gpu/attachment.h"

namespace morphgrid {

struct DrawPassOptions {
  vk::Format format;            ///< Of the images that are drawn into.
  std::uint32_t samples = 1;    ///< Of a pixel, where the device has as many: 1 or 4.
  vk::ImageLayout finalLayout;  ///< Of these images.
};

/// How pictures are drawn: on white, with a depth test. Shaders see all that was written before,
/// and what is written later waits for them.
class DrawPass {
 public:
  /// Throws DeviceError when the device refuses.
  DrawPass(const Device& device, const DrawPassOptions& options);

  vk::RenderPass renderPass() const { return *renderPass_; }
  vk::SampleCountFlagBits samples() const { return samples_; }
  vk::Format format() const { return format_; }
  vk::Format depthFormat() const { return depthFormat_; }

 private:
  vk::Format format_;
  vk::SampleCountFlagBits samples_;
  vk::Format depthFormat_;
  vk::raii::RenderPass renderPass_;
};

/// Images of one size to draw into by a pass, with what it needs beside them.
class Canvas {
 public:
  /// width, height > 0, in pixels; images: of this size and the pass's format; they and the pass
  /// must outlive it. Throws DeviceError when the device cannot draw such an image.
  Canvas(const Device& device, const DrawPass& pass, std::uint32_t width, std::uint32_t height,
         const std::vector<vk::ImageView>& images);

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }

  /// Records the pass, `draw` inside it, into the image of this index.
  void record(const vk::raii::CommandBuffer& commands, std::size_t image,
              const std::function<void(const vk::raii::CommandBuffer&)>& draw) const;

 private:
  vk::RenderPass renderPass_;
  std::uint32_t width_;
  std::uint32_t height_;
  std::optional<Attachment> multisampled_;  ///< Only where a pixel has several samples.
  Attachment depth_;
  std::vector<vk::raii::Framebuffer> framebuffers_;
};

}  // namespace morphgrid
