#pragma once
#include <memory>
#include <tuple>
#include <variant>
#include <vector>

#include "gpu/buffer.h"

namespace morphgrid {

/// What a shader reaches of a storage buffer. Devices limit `bytes`, whatever the buffer's size,
/// and choose what `offset` is a multiple of (at most 256).
struct BufferRange {
  // NOLINTNEXTLINE(google-explicit-constructor): a buffer stands for all of it.
  BufferRange(const Buffer* whole) : buffer(whole), offset(0), bytes(whole->bytes()) {}
  BufferRange(const Buffer* part, std::uint64_t from, std::uint64_t length)
      : buffer(part), offset(from), bytes(length) {}

  const Buffer* buffer;
  std::uint64_t offset;
  std::uint64_t bytes;
};

/// As Vulkan calls them.
enum class ResourceType { storageBuffer, uniformTexelBuffer, storageTexelBuffer };

/// What a shader reads or writes at a binding number: a storage buffer or a view of texels.
struct KernelResource {
  std::uint32_t binding;
  std::variant<BufferRange, const TexelView*> resource;

  ResourceType type() const;
};

/// A binding number and what kind of resource goes there.
struct ResourceSlot {
  std::uint32_t binding;
  ResourceType type;

  bool operator<(const ResourceSlot& other) const {
    return std::tie(binding, type) < std::tie(other.binding, other.type);
  }
};

std::vector<ResourceSlot> slotsOf(const std::vector<KernelResource>& resources);

enum class ShaderStage { compute, vertex };

/// The slots of a shader.
class ResourceLayout {
 public:
  /// Throws DeviceError when the device refuses.
  ResourceLayout(const Device& device, const std::vector<ResourceSlot>& slots, ShaderStage stage);
  ResourceLayout(ResourceLayout&&) = default;
  ResourceLayout& operator=(ResourceLayout&&) = default;

  VkDescriptorSetLayout handle() const { return handle_; }

 private:
  VkDescriptorSetLayout handle_ = nullptr;
  std::shared_ptr<const void> owned_;
};

/// Resources bound together. They must outlive it.
class ResourceSet {
 public:
  /// Throws DeviceError when the device refuses, or cannot reach as much of a buffer.
  ResourceSet(const Device& device, const ResourceLayout& layout,
              const std::vector<KernelResource>& resources);
  ResourceSet(ResourceSet&&) = default;
  ResourceSet& operator=(ResourceSet&&) = default;

  VkDescriptorSet handle() const { return handle_; }

 private:
  VkDescriptorSet handle_ = nullptr;
  std::shared_ptr<const void> owned_;
};

}  // namespace morphgrid
