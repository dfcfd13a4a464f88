#pragma once
#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "gpu/handle_names.h"
#include "gpu/memory_use.h"

namespace morphgrid {

class KernelProfile;
class KernelPrograms;
class SubmissionPace;
struct DeviceHandles;  // gpu/vulkan_device.h

struct DeviceSummary {
  std::string name;
  std::string type;  ///< "discrete GPU", "CPU", ...
  std::string apiVersion;
};

/// All Vulkan devices, in the order of the indices that DeviceOptions::selection takes.
/// Throws DeviceError when there is no Vulkan at all.
std::vector<DeviceSummary> listDevices();

/// What a device needs to show pictures in windows.
struct Presentation {
  std::vector<std::string> instanceExtensions;
  /// Whether a queue family of a device can present to where windows open.
  std::function<bool(VkInstance, VkPhysicalDevice, std::uint32_t queueFamily)> isSupported;
};

struct DeviceOptions {
  /// An index, or a part of a device's name in any case; empty: the first device that will do.
  std::string selection;
  /// Core and synchronization validation; messages are collected in validationMessages().
  bool validation = false;
  /// Whether to time every call on the device, which costs a little; see Device::profile().
  bool profile = false;
  /// For windows; only devices that can present will do then.
  std::optional<Presentation> presentation;
  /// Bytes of a storage buffer that shaders reach, at most: for tests of what does not fit.
  std::uint32_t largestStorageBuffer = std::numeric_limits<std::uint32_t>::max();
};

/// What Vulkan calls these, of a device: the most that it does.
struct DeviceLimits {
  std::uint32_t maxStorageBufferRange;    ///< Bytes that shaders reach of a buffer.
  std::uint32_t maxTexelBufferElements;   ///< Texels that shaders reach of a buffer.
  std::uint64_t maxMemoryAllocationSize;  ///< Bytes of a buffer.
  /// Workgroups of a dispatch along x, y, z.
  std::array<std::uint32_t, 3> maxComputeWorkGroupCount;
};

/// A Vulkan device with one queue for compute, graphics, transfer and, where asked for, windows.
class Device {
 public:
  /// Throws DeviceError that says what is missing and what to do.
  explicit Device(const DeviceOptions& options = {});

  const DeviceHandles& handles() const { return *handles_; }
  /// To be held wherever the queue is used: windows and solvers do so on threads of their own.
  std::mutex& queueMutex() const { return *queueMutex_; }
  const DeviceLimits& limits() const { return limits_; }
  const std::string& name() const { return name_; }
  /// Whether shaders can compute in double precision.
  bool hasFloat64() const { return hasFloat64_; }
  /// Invocations that run in lockstep.
  std::uint32_t subgroupSize() const { return subgroupSize_; }

  /// What its buffers take, host-visible ones too, as the driver rounds their sizes.
  MemoryUse& memoryUse() const { return *memoryUse_; }

  /// Null unless windows are drawn into: then submissions must be short.
  SubmissionPace* pace() const { return pace_.get(); }

  /// Times of all calls since it was last cleared; null unless DeviceOptions::profile.
  KernelProfile* profile() const { return profile_.get(); }

  /// Compiled for this device so far.
  KernelPrograms& programs() const { return *programs_; }

  /// What the validation layers said so far; empty when all is well.
  const std::vector<std::string>& validationMessages() const { return *messages_; }

 private:
  // Behind a pointer: the layers' callback keeps its address when the Device moves.
  std::unique_ptr<std::vector<std::string>> messages_;
  std::unique_ptr<MemoryUse> memoryUse_;  // Buffers keep its address.
  std::shared_ptr<const DeviceHandles> handles_;
  std::string name_;
  DeviceLimits limits_;
  bool hasFloat64_;
  std::uint32_t subgroupSize_;
  std::unique_ptr<std::mutex> queueMutex_;
  std::shared_ptr<SubmissionPace> pace_;
  std::shared_ptr<KernelPrograms> programs_;
  std::shared_ptr<KernelProfile> profile_;
};

}  // namespace morphgrid
