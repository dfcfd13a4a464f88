#include "gpu/compute_kernel.h"

#include <fmt/format.h>

#include "core/error.h"

namespace morphgrid {
namespace {

vk::raii::DescriptorSetLayout createSetLayout(const Device& device,
                                              const std::vector<KernelResource>& resources) {
  std::vector<vk::DescriptorSetLayoutBinding> bindings;
  for (const KernelResource& resource : resources) {
    bindings.emplace_back(resource.binding, resource.type(), 1, vk::ShaderStageFlagBits::eCompute);
  }
  return {device.handle(), vk::DescriptorSetLayoutCreateInfo({}, bindings)};
}

vk::raii::Pipeline createPipeline(const Device& device, std::span<const std::uint32_t> spirv,
                                  vk::PipelineLayout layout,
                                  const std::vector<std::uint32_t>& specialization) {
  const vk::raii::ShaderModule module(
      device.handle(), vk::ShaderModuleCreateInfo({}, spirv.size_bytes(), spirv.data()));
  std::vector<vk::SpecializationMapEntry> entries;
  for (std::uint32_t n = 0; n < specialization.size(); ++n) {
    entries.emplace_back(n, static_cast<std::uint32_t>(n * sizeof(std::uint32_t)),
                         sizeof(std::uint32_t));
  }
  const vk::SpecializationInfo constants(static_cast<std::uint32_t>(entries.size()), entries.data(),
                                         specialization.size() * sizeof(std::uint32_t),
                                         specialization.data());
  const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module,
                                                "main", &constants);
  return {device.handle(), nullptr, vk::ComputePipelineCreateInfo({}, stage, layout)};
}

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
  return std::holds_alternative<const Buffer*>(resource) ? vk::DescriptorType::eStorageBuffer
                                                         : vk::DescriptorType::eUniformTexelBuffer;
}

ComputeKernel::ComputeKernel(const Device& device, std::span<const std::uint32_t> spirv,
                             const std::vector<KernelResource>& resources,
                             std::uint32_t pushConstantBytes,
                             const std::vector<std::uint32_t>& specialization) {
  try {
    setLayout_ = createSetLayout(device, resources);
    const vk::PushConstantRange push(vk::ShaderStageFlagBits::eCompute, 0, pushConstantBytes);
    layout_ = vk::raii::PipelineLayout(
        device.handle(),
        vk::PipelineLayoutCreateInfo({}, 1, &*setLayout_, pushConstantBytes > 0 ? 1 : 0, &push));
    pipeline_ = createPipeline(device, spirv, *layout_, specialization);
    pool_ = createPool(device, resources);
    set_ = std::move(vk::raii::DescriptorSets(device.handle(),
                                              vk::DescriptorSetAllocateInfo(*pool_, *setLayout_))
                         .front());
  } catch (const vk::SystemError& error) {
    throw DeviceError(
        fmt::format("device {} cannot build a compute kernel: {}", device.name(), error.what()));
  }
  for (const KernelResource& resource : resources) {
    writeDescriptor(device, *set_, resource);
  }
}

}  // namespace morphgrid
