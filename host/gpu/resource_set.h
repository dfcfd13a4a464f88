#pragma once
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
  BufferRange(const Buffer* part, vk::DeviceSize from, vk::DeviceSize length)
      : buffer(part), offset(from), bytes(length) {}

  const Buffer* buffer;
  vk::DeviceSize offset;
  vk::DeviceSize bytes;
};

/// What a shader reads or writes at a binding number: a storage buffer or a view of texels.
struct KernelResource {
  std::uint32_t binding;
  std::variant<BufferRange, const TexelView*> resource;

  vk::DescriptorType type() const;
};

/// A binding number and what kind of resource goes there.
struct ResourceSlot {
  std::uint32_t binding;
  vk::DescriptorType type;

  bool operator<(const ResourceSlot& other) const {
    return std::tie(binding, type) < std::tie(other.binding, other.type);
  }
};

std::vector<ResourceSlot> slotsOf(const std::vector<KernelResource>& resources);

vk::raii::DescriptorSetLayout createSetLayout(const Device& device,
                                              const std::vector<ResourceSlot>& slots,
                                              vk::ShaderStageFlags stages);

/// Resources bound together. They must outlive it.
class ResourceSet {
 public:
  /// Throws DeviceError when the device cannot reach as much of a buffer.
  ResourceSet(const Device& device, vk::DescriptorSetLayout layout,
              const std::vector<KernelResource>& resources);

  vk::DescriptorSet handle() const { return *set_; }

 private:
  vk::raii::DescriptorPool pool_;
  vk::raii::DescriptorSet set_;
};

}  // namespace morphgrid
