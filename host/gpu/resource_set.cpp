#include "gpu/resource_set.h"

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

void writeDescriptor(const Device& device, vk::DescriptorSet set, const KernelResource& resource) {
  vk::WriteDescriptorSet write(set, resource.binding, 0, 1, resource.type());
  if (const auto* buffer = std::get_if<const Buffer*>(&resource.resource)) {
    const vk::DescriptorBufferInfo info((*buffer)->handle(), 0, VK_WHOLE_SIZE);
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
  if (std::holds_alternative<const Buffer*>(resource)) {
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
