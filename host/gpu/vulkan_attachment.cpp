#include "gpu/vulkan_attachment.h"

#include <fmt/format.h>

#include "core/error.h"

namespace morphgrid {
namespace {

void checkSize(const Device& device, const vk::ImageCreateInfo& info) {
  vk::Extent3D largest;
  try {
    largest =
        device.handles()
            .physical.getImageFormatProperties(info.format, info.imageType, info.tiling, info.usage)
            .maxExtent;
  } catch (const vk::FormatNotSupportedError&) {
    throw DeviceError(
        fmt::format("device {} cannot draw {}", device.name(), vk::to_string(info.format)));
  }
  const vk::PhysicalDeviceLimits& limits = device.handles().properties.limits;
  const auto width =
      std::min({largest.width, limits.maxFramebufferWidth, limits.maxViewportDimensions[0]});
  const auto height =
      std::min({largest.height, limits.maxFramebufferHeight, limits.maxViewportDimensions[1]});
  if (info.extent.width > width || info.extent.height > height) {
    throw DeviceError(fmt::format("device {} draws at most {} x {} pixels, got {} x {}",
                                  device.name(), width, height, info.extent.width,
                                  info.extent.height));
  }
}

}  // namespace

Attachment::Attachment(const Device& device, PixelSize size, vk::Format format,
                       vk::SampleCountFlagBits samples, vk::ImageUsageFlags usage) {
  const vk::ImageCreateInfo info({}, vk::ImageType::e2D, format,
                                 vk::Extent3D(size.width, size.height, 1), 1, 1, samples,
                                 vk::ImageTiling::eOptimal, usage);
  checkSize(device, info);
  const auto aspect = usage & vk::ImageUsageFlagBits::eDepthStencilAttachment
                          ? vk::ImageAspectFlagBits::eDepth
                          : vk::ImageAspectFlagBits::eColor;
  try {
    image_ = vk::raii::Image(device.handles().device, info);
    const auto needs = image_.getMemoryRequirements();
    memory_ = vk::raii::DeviceMemory(
        device.handles().device,
        vk::MemoryAllocateInfo(needs.size, device.handles().memoryType(needs.memoryTypeBits, {})));
    image_.bindMemory(*memory_, 0);
    view_ =
        vk::raii::ImageView(device.handles().device,
                            vk::ImageViewCreateInfo({}, *image_, vk::ImageViewType::e2D, format, {},
                                                    vk::ImageSubresourceRange(aspect, 0, 1, 0, 1)));
  } catch (const vk::SystemError& error) {
    throw DeviceError(fmt::format("an image of {} x {} pixels cannot be had: {}", size.width,
                                  size.height, error.what()));
  }
}

}  // namespace morphgrid
