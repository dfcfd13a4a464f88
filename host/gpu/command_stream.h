#pragma once
#include "gpu/call_timer.h"
#include "gpu/compute_kernel.h"
#include "gpu/submission_pace.h"

namespace morphgrid {

/// Commands recorded once and submitted as often as wanted. Dispatches and copies are ordered: each
/// sees what the ones before it wrote. Where a window shares the device, they go to it in parts, so
/// that its frames get in between.
class CommandStream {
 public:
  explicit CommandStream(const Device& device);

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

  void copy(const Buffer& from, const Buffer& to, vk::DeviceSize bytes,
            vk::DeviceSize fromOffset = 0);
  /// All its bytes become 0.
  void clear(const Buffer& buffer);
  void end();

  /// Runs what was recorded and waits. Throws DeviceError when the device fails.
  void submitAndWait();

  /// For commands that this class does not know (rendering).
  const vk::raii::CommandBuffer& commands() const { return parts_[last_].commands; }

 private:
  void dispatchBytes(const ComputeKernel& kernel, const void* push, std::uint32_t pushBytes,
                     std::uint32_t groupsX, std::uint32_t groupsY, std::uint32_t groupsZ);
  /// What cannot be submitted but at once.
  struct Part {
    vk::raii::CommandBuffer commands;
    std::vector<CallWork> work;
    long groups = 0;
  };

  bool isCut() const;
  void beginPart(std::size_t part);
  /// A call that is to be recorded.
  void count(const CallWork& call);
  /// The first part that is not to be submitted together with `first`.
  std::size_t endOfSubmission(std::size_t first) const;
  void submitAndWait(std::size_t first, std::size_t end);
  void orderAfterPrevious();
  void bind(const ComputeKernel& kernel, const void* push, std::uint32_t pushBytes);
  /// record(): one command, timed where the device keeps a profile.
  template <typename Record>
  void recordTimed(const char* name, Record record) {
    if (timer_) {
      timer_->recordStart(commands(), name);
    }
    record();
    if (timer_) {
      timer_->recordEnd(commands());
    }
  }

  const Device& device_;
  vk::raii::CommandPool pool_ = nullptr;
  std::vector<Part> parts_;
  std::size_t last_ = 0;  ///< Of the parts in use.
  vk::raii::Fence fence_ = nullptr;
  std::optional<CallTimer> timer_;
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
