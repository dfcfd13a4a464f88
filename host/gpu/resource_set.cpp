#include "gpu/resource_set.h"

#include <fmt/format.h>

#include "core/error.h"
#include "gpu/vulkan_device.h"

namespace morphgrid {
namespace {

struct OwnedSet {
  vk::raii::DescriptorPool pool;
  vk::raii::DescriptorSet set;
};

vk::DescriptorType vulkanType(ResourceType type) {
  switch (type) {
    case ResourceType::storageBuffer:
      return vk::DescriptorType::eStorageBuffer;
    case ResourceType::uniformTexelBuffer:
      return vk::DescriptorType::eUniformTexelBuffer;
    case ResourceType::storageTexelBuffer:
      break;
  }
  return vk::DescriptorType::eStorageTexelBuffer;
}

vk::raii::DescriptorPool createPool(const Device& device,
                                    const std::vector<KernelResource>& resources) {
  std::vector<vk::DescriptorPoolSize> sizes;
  for (const KernelResource& resource : resources) {
    sizes.emplace_back(vulkanType(resource.type()), 1);
  }
  return {
      device.handles().device,
      vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes)};
}

vk::DescriptorBufferInfo bufferInfo(const Device& device, const BufferRange& range) {
  const std::uint64_t limit = device.limits().maxStorageBufferRange;
  if (range.bytes > limit) {
    throw DeviceError(fmt::format(
        "device {} binds at most {} MiB of a buffer, {} MiB are needed; use a smaller grid",
        device.name(), limit >> 20, (range.bytes + (1 << 20) - 1) >> 20));
  }
  return {range.buffer->handle(), range.offset, range.bytes};
}

void writeDescriptor(const Device& device, vk::DescriptorSet set, const KernelResource& resource) {
  const vk::raii::Device& handle = device.handles().device;
  vk::WriteDescriptorSet write(set, resource.binding, 0, 1, vulkanType(resource.type()));
  if (const auto* range = std::get_if<BufferRange>(&resource.resource)) {
    const vk::DescriptorBufferInfo info = bufferInfo(device, *range);
    write.pBufferInfo = &info;
    handle.updateDescriptorSets(write, {});
  } else {
    const vk::BufferView view = std::get<const TexelView*>(resource.resource)->handle();
    write.pTexelBufferView = &view;
    handle.updateDescriptorSets(write, {});
  }
}

}  // namespace

ResourceType KernelResource::type() const {
  if (std::holds_alternative<BufferRange>(resource)) {
    return ResourceType::storageBuffer;
  }
  return std::get<const TexelView*>(resource)->access() == TexelAccess::fetch
             ? ResourceType::uniformTexelBuffer
             : ResourceType::storageTexelBuffer;
}

std::vector<ResourceSlot> slotsOf(const std::vector<KernelResource>& resources) {
  std::vector<ResourceSlot> slots;
  for (const KernelResource& resource : resources) {
    slots.push_back({resource.binding, resource.type()});
  }
  return slots;
}

ResourceLayout::ResourceLayout(const Device& device, const std::vector<ResourceSlot>& slots,
                               ShaderStage stage) try {
  const auto stages = stage == ShaderStage::compute ? vk::ShaderStageFlagBits::eCompute
                                                    : vk::ShaderStageFlagBits::eVertex;
  std::vector<vk::DescriptorSetLayoutBinding> bindings;
  for (const ResourceSlot& slot : slots) {
    bindings.emplace_back(slot.binding, vulkanType(slot.type), 1, stages);
  }
  auto layout = std::make_shared<const vk::raii::DescriptorSetLayout>(
      device.handles().device, vk::DescriptorSetLayoutCreateInfo({}, bindings));
  handle_ = **layout;
  owned_ = std::move(layout);
} catch (const vk::SystemError& error) {
  throw DeviceError(
      fmt::format("device {} cannot lay out a shader's buffers: {}", device.name(), error.what()));
}

ResourceSet::ResourceSet(const Device& device, const ResourceLayout& layout,
                         const std::vector<KernelResource>& resources) try {
  const vk::DescriptorSetLayout handle = layout.handle();
  vk::raii::DescriptorPool pool = createPool(device, resources);
  vk::raii::DescriptorSets sets(device.handles().device,
                                vk::DescriptorSetAllocateInfo(*pool, handle));
  for (const KernelResource& resource : resources) {
    writeDescriptor(device, *sets.front(), resource);
  }
  handle_ = *sets.front();
  owned_ = std::make_shared<const OwnedSet>(OwnedSet{std::move(pool), std::move(sets.front())});
} catch (const vk::SystemError& error) {
  throw DeviceError(
      fmt::format("device {} cannot bind a shader's buffers: {}", device.name(), error.what()));
}

}  // namespace morphgrid
