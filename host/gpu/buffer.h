#pragma once
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>

#include "gpu/device.h"

namespace morphgrid {

enum class MemoryKind {
  device,  ///< Fast for shaders; the host reaches it through copies.
  host,    ///< Mapped, coherent: for staging, small states and results.
};

/// What a buffer is used for, as Vulkan calls it; joined by |.
enum class BufferUsage : std::uint32_t {
  storageBuffer = 1,
  uniformTexelBuffer = 2,  ///< For TexelAccess::fetch.
  storageTexelBuffer = 4,  ///< For TexelAccess::image.
  transferSrc = 8,
  transferDst = 16,
};

constexpr BufferUsage operator|(BufferUsage a, BufferUsage b) {
  return static_cast<BufferUsage>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}

/// A buffer with memory of its own.
class Buffer {
 public:
  /// bytes > 0. Throws DeviceError when memory runs out.
  Buffer(const Device& device, std::uint64_t bytes, BufferUsage usage, MemoryKind kind);
  Buffer(Buffer&&) = default;
  Buffer& operator=(Buffer&&) = default;

  VkBuffer handle() const { return handle_; }
  std::uint64_t bytes() const { return bytes_; }

  /// The mapped content of a host buffer, as values of T.
  template <typename T>
  std::span<T> mapped() const {
    return {static_cast<T*>(mapped_), static_cast<std::size_t>(bytes_ / sizeof(T))};
  }

 private:
  std::uint64_t bytes_;
  VkBuffer handle_ = nullptr;
  void* mapped_ = nullptr;
  std::shared_ptr<const void> owned_;  ///< The buffer and its memory.
};

/// The format of texels, of four components each.
enum class TexelFormat { float4, int4 };
constexpr std::uint32_t kTexelBytes = 16;

enum class TexelAccess {
  fetch,  ///< A samplerBuffer, read by texelFetch.
  image,  ///< An imageBuffer, read by imageLoad.
};

/// A view through which shaders read a buffer as texels.
class TexelView {
 public:
  /// Throws DeviceError when the buffer has more texels than the device allows.
  TexelView(const Device& device, const Buffer& buffer, TexelFormat format,
            TexelAccess access = TexelAccess::fetch);
  TexelView(TexelView&&) = default;
  TexelView& operator=(TexelView&&) = default;

  VkBufferView handle() const { return handle_; }
  TexelAccess access() const { return access_; }

 private:
  TexelAccess access_;
  VkBufferView handle_ = nullptr;
  std::shared_ptr<const void> owned_;
};

}  // namespace morphgrid
