#pragma once
#include <cstring>
#include <span>

#include "gpu/device.h"

namespace morphgrid {

enum class MemoryKind {
  device,  ///< Fast for shaders; the host reaches it through copies.
  host,    ///< Mapped, coherent: for staging, small states and results.
};

/// A buffer with memory of its own.
class Buffer {
 public:
  /// bytes > 0. Throws DeviceError when memory runs out.
  Buffer(const Device& device, vk::DeviceSize bytes, vk::BufferUsageFlags usage, MemoryKind kind);

  vk::Buffer handle() const { return *buffer_; }
  vk::DeviceSize bytes() const { return bytes_; }

  /// The mapped content of a host buffer, as values of T.
  template <typename T>
  std::span<T> mapped() const {
    return {static_cast<T*>(mapped_), static_cast<std::size_t>(bytes_ / sizeof(T))};
  }

 private:
  vk::DeviceSize bytes_;
  vk::raii::Buffer buffer_ = nullptr;
  vk::raii::DeviceMemory memory_ = nullptr;
  std::shared_ptr<const void> counted_;  ///< In the device's use of memory.
  void* mapped_ = nullptr;
};

enum class TexelAccess {
  fetch,  ///< A samplerBuffer, read by texelFetch.
  image,  ///< An imageBuffer, read by imageLoad.
};

/// A view through which shaders read a buffer as texels.
class TexelView {
 public:
  /// Throws DeviceError when the buffer has more texels than the device allows.
  TexelView(const Device& device, const Buffer& buffer, vk::Format format,
            std::uint32_t bytesPerTexel, TexelAccess access = TexelAccess::fetch);

  vk::BufferView handle() const { return *view_; }
  TexelAccess access() const { return access_; }

 private:
  TexelAccess access_;
  vk::raii::BufferView view_ = nullptr;
};

}  // namespace morphgrid
