#pragma once
#include <vulkan/vulkan_raii.hpp>

#include "gpu/device.h"

namespace morphgrid {

/// What calls of Vulkan need of a Device.
struct DeviceHandles {
  /// The index of a memory type with these properties; throws DeviceError when there is none.
  std::uint32_t memoryType(std::uint32_t allowedBits, vk::MemoryPropertyFlags wanted) const;

  vk::raii::Context context;
  vk::raii::Instance instance;
  vk::raii::DebugUtilsMessengerEXT messenger;
  vk::raii::PhysicalDevice physical;
  vk::PhysicalDeviceProperties properties;
  std::uint32_t queueFamily;
  vk::raii::Device device;
  vk::raii::Queue queue;
};

}  // namespace morphgrid
