#include "gpu/available_memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

#include "gpu/vulkan_device.h"

namespace morphgrid {
namespace {

/// Without /proc/meminfo: no bound is known.
std::uint64_t availableOnHost() {
  std::ifstream stream("/proc/meminfo");
  std::string name;
  std::uint64_t kibibytes = 0;
  std::string unit;
  while (stream >> name >> kibibytes) {
    if (name == "MemAvailable:") {
      return kibibytes << 10;
    }
    std::getline(stream, unit);
  }
  return std::numeric_limits<std::uint64_t>::max();
}

bool tellsBudget(const vk::raii::PhysicalDevice& physical) {
  const auto extensions = physical.enumerateDeviceExtensionProperties();
  return std::any_of(extensions.begin(), extensions.end(), [](const auto& extension) {
    return std::string_view(extension.extensionName) == VK_EXT_MEMORY_BUDGET_EXTENSION_NAME;
  });
}

std::uint64_t availableOnDevice(const vk::raii::PhysicalDevice& physical) {
  const auto chain = physical.getMemoryProperties2<vk::PhysicalDeviceMemoryProperties2,
                                                   vk::PhysicalDeviceMemoryBudgetPropertiesEXT>();
  const auto& memory = chain.get<vk::PhysicalDeviceMemoryProperties2>().memoryProperties;
  const auto& budget = chain.get<vk::PhysicalDeviceMemoryBudgetPropertiesEXT>();
  const bool budgetIsKnown = tellsBudget(physical);
  std::uint64_t largest = 0;
  for (std::uint32_t n = 0; n < memory.memoryHeapCount; ++n) {
    if (memory.memoryHeaps[n].flags & vk::MemoryHeapFlagBits::eDeviceLocal) {
      const std::uint64_t used = std::min(budget.heapUsage[n], budget.heapBudget[n]);
      largest = std::max(largest,
                         budgetIsKnown ? budget.heapBudget[n] - used : memory.memoryHeaps[n].size);
    }
  }
  return largest;
}

}  // namespace

AvailableMemory availableMemory(const Device& device) {
  const bool shared =
      device.handles().physical.getProperties().deviceType == vk::PhysicalDeviceType::eCpu;
  const std::uint64_t host = availableOnHost();
  return {shared ? host : availableOnDevice(device.handles().physical), host, shared};
}

}  // namespace morphgrid
