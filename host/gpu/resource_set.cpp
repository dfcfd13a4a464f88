#include "gpu/resource_set.h"

#include <fmt/format.h>

#include "core/error.h"

namespace morphgrid {
namespace {

vk::raii::DescriptorPool createPool(const Device& device,
                                    const std::vector<KernelResource>& resources) {
  std::vector<vk::DescriptorPoolSize> sizes;
  for (const KernelResource& resource : resources) {
    sizes.emplace_back(resource.type(), 1);
  }
  return {device.handle(), vk::DescriptorPoolCreateInfo(
                               vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes)};
}

vk::DescriptorBufferInfo bufferInfo(const Device& device, const BufferRange& range) {
  const vk::DeviceSize limit = device.limits().maxStorageBufferRange;
  if (range.bytes > limit) {
    throw DeviceError(fmt::format(
        "device {} binds at most {} MiB of a buffer, {} MiB are needed; use a smaller grid",
        device.name(), limit >> 20, (range.bytes + (1 << 20) - 1) >> 20));
  }
  return {range.buffer->handle(), range.offset, range.bytes};
}

void writeDescriptor(const Device& device, vk::DescriptorSet set, const KernelResource& resource) {
  vk::WriteDescriptorSet write(set, resource.binding, 0, 1, resource.type());
  if (const auto* range = std::get_if<BufferRange>(&resource.resource)) {
    const vk::DescriptorBufferInfo info = bufferInfo(device, *range);
    write.pBufferInfo = &info;
    device.handle().updateDescriptorSets(write, {});
  } else {
    const vk::BufferView view = std::get<const TexelView*>(resource.resource)->handle();
    write.pTexelBufferView = &view;
    device.handle().updateDescriptorSets(write, {});
  }
}

}  // namespace

vk::DescriptorType KernelResource::type() const {
  if (std::holds_alternative<BufferRange>(resource)) {
    return vk::DescriptorType::eStorageBuffer;
  }
  return std::get<const TexelView*>(resource)->access() == TexelAccess::fetch
             ? vk::DescriptorType::eUniformTexelBuffer
             : vk::DescriptorType::eStorageTexelBuffer;
}

std::vector<ResourceSlot> slotsOf(const std::vector<KernelResource>& resources) {
  std::vector<ResourceSlot> slots;
  for (const KernelResource& resource : resources) {
    slots.push_back({resource.binding, resource.type()});
  }
  return slots;
}

vk::raii::DescriptorSetLayout createSetLayout(const Device& device,
                                              const std::vector<ResourceSlot>& slots,
                                              vk::ShaderStageFlags stages) {
  std::vector<vk::DescriptorSetLayoutBinding> bindings;
  for (const ResourceSlot& slot : slots) {
    bindings.emplace_back(slot.binding, slot.type, 1, stages);
  }
  return {device.handle(), vk::DescriptorSetLayoutCreateInfo({}, bindings)};
}

ResourceSet::ResourceSet(const Device& device, vk::DescriptorSetLayout layout,
                         const std::vector<KernelResource>& resources)
    : pool_(createPool(device, resources)),
      set_(std::move(
          vk::raii::DescriptorSets(device.handle(), vk::DescriptorSetAllocateInfo(*pool_, layout))
              .front())) {
  for (const KernelResource& resource : resources) {
    writeDescriptor(device, *set_, resource);
  }
}

}  // namespace morphgrid
