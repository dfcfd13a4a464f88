#include "gpu/buffer.h"

#include <fmt/format.h>

#include "core/error.h"

namespace morphgrid {
namespace {

vk::MemoryPropertyFlags propertiesOf(MemoryKind kind) {
  using Property = vk::MemoryPropertyFlagBits;
  return kind == MemoryKind::device ? vk::MemoryPropertyFlags(Property::eDeviceLocal)
                                    : Property::eHostVisible | Property::eHostCoherent;
}

}  // namespace

Buffer::Buffer(const Device& device, vk::DeviceSize bytes, vk::BufferUsageFlags usage,
               MemoryKind kind)
    : bytes_(bytes) {
  try {
    buffer_ = vk::raii::Buffer(device.handle(), vk::BufferCreateInfo({}, bytes, usage));
    const auto needs = buffer_.getMemoryRequirements();
    memory_ = vk::raii::DeviceMemory(
        device.handle(), vk::MemoryAllocateInfo(needs.size, device.memoryType(needs.memoryTypeBits,
                                                                              propertiesOf(kind))));
    counted_ = device.memoryUse().hold(needs.size);
    buffer_.bindMemory(*memory_, 0);
    if (kind == MemoryKind::host) {
      mapped_ = memory_.mapMemory(0, VK_WHOLE_SIZE);
    }
  } catch (const vk::SystemError& error) {
    throw DeviceError(
        fmt::format("{} bytes of device memory cannot be had: {}", bytes, error.what()));
  }
}

TexelView::TexelView(const Device& device, const Buffer& buffer, vk::Format format,
                     std::uint32_t bytesPerTexel, TexelAccess access)
    : access_(access) {
  const vk::DeviceSize texels = buffer.bytes() / bytesPerTexel;
  if (texels > device.limits().maxTexelBufferElements) {
    throw DeviceError(
        fmt::format("device {} reads at most {} texels of a buffer, {} are needed; use a "
                    "smaller grid",
                    device.name(), device.limits().maxTexelBufferElements, texels));
  }
  view_ = vk::raii::BufferView(
      device.handle(), vk::BufferViewCreateInfo({}, buffer.handle(), format, 0, VK_WHOLE_SIZE));
}

}  // namespace morphgrid
