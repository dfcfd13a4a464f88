#include "gpu/attachment.h"

#include <fmt/format.h>

#include "core/error.h"

namespace morphgrid {
namespace {

void checkSize(const Device& device, const vk::ImageCreateInfo& info) {
  vk::Extent3D largest;
  try {
    largest = device.physical()
                  .getImageFormatProperties(info.format, info.imageType, info.tiling, info.usage)
                  .maxExtent;
  } catch (const vk::FormatNotSupportedError&) {
    throw DeviceError(
        fmt::format("device {} cannot draw {}", device.name(), vk::to_string(info.format)));
  }
  const auto& limits = device.limits();
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

Attachment::Attachment(const Device& device, std::uint32_t width, std::uint32_t height,
                       vk::Format format, vk::SampleCountFlagBits samples,
                       vk::ImageUsageFlags usage) {
  const vk::ImageCreateInfo info({}, vk::ImageType::e2D, format, vk::Extent3D(width, height, 1), 1,
                                 1, samples, vk::ImageTiling::eOptimal, usage);
  checkSize(device, info);
  const auto aspect = usage & vk::ImageUsageFlagBits::eDepthStencilAttachment
                          ? vk::ImageAspectFlagBits::eDepth
                          : vk::ImageAspectFlagBits::eColor;
  try {
    image_ = vk::raii::Image(device.handle(), info);
    const auto needs = image_.getMemoryRequirements();
    memory_ = vk::raii::DeviceMemory(
        device.handle(),
        vk::MemoryAllocateInfo(needs.size, device.memoryType(needs.memoryTypeBits, {})));
    image_.bindMemory(*memory_, 0);
    view_ = vk::raii::ImageView(
        device.handle(), vk::ImageViewCreateInfo({}, *image_, vk::ImageViewType::e2D, format, {},
                                                 vk::ImageSubresourceRange(aspect, 0, 1, 0, 1)));
  } catch (const vk::SystemError& error) {
    throw DeviceError(
        fmt::format("an image of {} x {} pixels cannot be had: {}", width, height, error.what()));
  }
}

}  // namespace morphgrid
