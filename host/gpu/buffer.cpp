#include "gpu/buffer.h"

#include <fmt/format.h>

#include "core/error.h"
#include "gpu/vulkan_device.h"

namespace morphgrid {
namespace {

vk::MemoryPropertyFlags propertiesOf(MemoryKind kind) {
  using Property = vk::MemoryPropertyFlagBits;
  return kind == MemoryKind::device ? vk::MemoryPropertyFlags(Property::eDeviceLocal)
                                    : Property::eHostVisible | Property::eHostCoherent;
}

vk::BufferUsageFlags vulkanUsage(BufferUsage usage) {
  using Flag = vk::BufferUsageFlagBits;
  constexpr std::pair<BufferUsage, Flag> kFlags[] = {
      {BufferUsage::storageBuffer, Flag::eStorageBuffer},
      {BufferUsage::uniformTexelBuffer, Flag::eUniformTexelBuffer},
      {BufferUsage::storageTexelBuffer, Flag::eStorageTexelBuffer},
      {BufferUsage::transferSrc, Flag::eTransferSrc},
      {BufferUsage::transferDst, Flag::eTransferDst}};
  vk::BufferUsageFlags flags;
  for (const auto& [wanted, flag] : kFlags) {
    if ((usage | wanted) == usage) {
      flags |= flag;
    }
  }
  return flags;
}

struct OwnedBuffer {
  std::shared_ptr<const void> counted;  ///< In the device's use of memory.
  vk::raii::DeviceMemory memory;
  vk::raii::Buffer buffer;
};

}  // namespace

Buffer::Buffer(const Device& device, std::uint64_t bytes, BufferUsage usage, MemoryKind kind)
    : bytes_(bytes) {
  const DeviceHandles& handles = device.handles();
  try {
    vk::raii::Buffer buffer(handles.device, vk::BufferCreateInfo({}, bytes, vulkanUsage(usage)));
    const auto needs = buffer.getMemoryRequirements();
    vk::raii::DeviceMemory memory(
        handles.device, vk::MemoryAllocateInfo(needs.size, handles.memoryType(needs.memoryTypeBits,
                                                                              propertiesOf(kind))));
    buffer.bindMemory(*memory, 0);
    if (kind == MemoryKind::host) {
      mapped_ = memory.mapMemory(0, VK_WHOLE_SIZE);
    }
    handle_ = *buffer;
    owned_ = std::make_shared<const OwnedBuffer>(
        OwnedBuffer{device.memoryUse().hold(needs.size), std::move(memory), std::move(buffer)});
  } catch (const vk::SystemError& error) {
    throw DeviceError(
        fmt::format("{} bytes of device memory cannot be had: {}", bytes, error.what()));
  }
}

TexelView::TexelView(const Device& device, const Buffer& buffer, TexelFormat format,
                     TexelAccess access)
    : access_(access) {
  const std::uint64_t texels = buffer.bytes() / kTexelBytes;
  if (texels > device.limits().maxTexelBufferElements) {
    throw DeviceError(
        fmt::format("device {} reads at most {} texels of a buffer, {} are needed; use a "
                    "smaller grid",
                    device.name(), device.limits().maxTexelBufferElements, texels));
  }
  const vk::Format texel = format == TexelFormat::float4 ? vk::Format::eR32G32B32A32Sfloat
                                                         : vk::Format::eR32G32B32A32Sint;
  auto view = std::make_shared<const vk::raii::BufferView>(
      device.handles().device,
      vk::BufferViewCreateInfo({}, buffer.handle(), texel, 0, VK_WHOLE_SIZE));
  handle_ = **view;
  owned_ = std::move(view);
}

}  // namespace morphgrid
