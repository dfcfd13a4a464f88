#pragma once
#include "gpu/pixel_size.h"
#include "gpu/vulkan_device.h"

namespace morphgrid {

/// An image to draw into, with memory of its own.
class Attachment {
 public:
  /// size > 0. Throws DeviceError when memory runs out or the device draws no image of
  /// this size and format.
  Attachment(const Device& device, PixelSize size, vk::Format format,
             vk::SampleCountFlagBits samples, vk::ImageUsageFlags usage);

  vk::Image handle() const { return *image_; }
  vk::ImageView view() const { return *view_; }

 private:
  vk::raii::Image image_ = nullptr;
  vk::raii::DeviceMemory memory_ = nullptr;
  vk::raii::ImageView view_ = nullptr;
};

}  // namespace morphgrid
