#pragma once
#include "gpu/compute_kernel.h"

namespace morphgrid {

class CommandBuffer;  // gpu/vulkan_commands.h

/// Commands recorded once and submitted as often as wanted. Dispatches and copies are ordered: each
/// sees what the ones before it wrote. Where a window shares the device, they go to it in parts, so
/// that its frames get in between.
class CommandStream {
 public:
  explicit CommandStream(const Device& device);
  ~CommandStream();
  CommandStream(CommandStream&&) noexcept;
  CommandStream& operator=(CommandStream&&) = delete;

  /// Throws away what was recorded.
  void begin();

  template <typename Push>
  void dispatch(const ComputeKernel& kernel, const Push& push, std::uint32_t groupsX,
                std::uint32_t groupsY = 1, std::uint32_t groupsZ = 1) {
    dispatchBytes(kernel, &push, sizeof(Push), groupsX, groupsY, groupsZ);
  }

  /// Without push constants.
  void dispatch(const ComputeKernel& kernel, std::uint32_t groupsX) {
    dispatchBytes(kernel, nullptr, 0, groupsX, 1, 1);
  }

  void copy(const Buffer& from, const Buffer& to, std::uint64_t bytes,
            std::uint64_t fromOffset = 0);
  /// All its bytes become 0.
  void clear(const Buffer& buffer);
  void end();

  /// Runs what was recorded and waits. Throws DeviceError when the device fails.
  void submitAndWait();

  /// For commands that this class does not know (rendering).
  const CommandBuffer& commands() const;

 private:
  class Recorder;

  void dispatchBytes(const ComputeKernel& kernel, const void* push, std::uint32_t pushBytes,
                     std::uint32_t groupsX, std::uint32_t groupsY, std::uint32_t groupsZ);

  std::unique_ptr<Recorder> recorder_;
};

/// Fills a device buffer with `data`, through a staging buffer.
void uploadBytes(const Device& device, const Buffer& buffer, const void* data, std::size_t bytes);
/// Reads a device buffer back.
void downloadBytes(const Device& device, const Buffer& buffer, void* data, std::size_t bytes);

template <typename T>
void upload(const Device& device, const Buffer& buffer, const std::vector<T>& values) {
  uploadBytes(device, buffer, values.data(), values.size() * sizeof(T));
}

template <typename T>
std::vector<T> download(const Device& device, const Buffer& buffer, std::size_t count) {
  std::vector<T> values(count);
  downloadBytes(device, buffer, values.data(), count * sizeof(T));
  return values;
}

}  // namespace morphgrid
