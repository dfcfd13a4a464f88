#pragma once
#include <string>
#include <vector>

#include "gpu/kernel_profile.h"
#include "gpu/vulkan_device.h"

namespace morphgrid {

/// Timestamps around the commands of a CommandStream.
class CallTimer {
 public:
  explicit CallTimer(const Device& device) : device_(device) {}

  /// Recording begins anew.
  void forget() { names_.clear(); }
  void recordStart(const vk::raii::CommandBuffer& commands, const char* name);
  void recordEnd(const vk::raii::CommandBuffer& commands);

  /// After what was recorded has run: adds its calls.
  void collect(KernelProfile& profile) const;

 private:
  const Device& device_;
  std::vector<vk::raii::QueryPool>
      pools_;  ///< Reset whenever the first of their calls is recorded.
  std::vector<const char*> names_;
};

}  // namespace morphgrid
