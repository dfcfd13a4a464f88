#pragma once
#include <vulkan/vulkan_raii.hpp>

namespace morphgrid {

/// Vulkan's, which headers name without Vulkan's own.
class CommandBuffer : public vk::raii::CommandBuffer {
 public:
  /// From `pool`, which must outlive it.
  CommandBuffer(const vk::raii::Device& device, const vk::raii::CommandPool& pool)
      : vk::raii::CommandBuffer(std::move(
            vk::raii::CommandBuffers(
                device, vk::CommandBufferAllocateInfo(*pool, vk::CommandBufferLevel::ePrimary, 1))
                .front())) {}
};

/// A pool of command buffers that are recorded again and again.
inline vk::raii::CommandPool createCommandPool(const vk::raii::Device& device,
                                               std::uint32_t queueFamily) {
  return {device, vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eResetCommandBuffer,
                                            queueFamily)};
}

}  // namespace morphgrid
