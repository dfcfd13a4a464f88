#include "gpu/compute_kernel.h"

#include <fmt/format.h>

#include "core/error.h"

namespace morphgrid {
namespace {

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

}  // namespace

ComputeKernel::ComputeKernel(const Device& device, std::span<const std::uint32_t> spirv,
                             const std::vector<KernelResource>& resources,
                             std::uint32_t pushConstantBytes,
                             const std::vector<std::uint32_t>& specialization) {
  try {
    Program program;
    program.setLayout =
        createSetLayout(device, slotsOf(resources), vk::ShaderStageFlagBits::eCompute);
    const vk::PushConstantRange push(vk::ShaderStageFlagBits::eCompute, 0, pushConstantBytes);
    program.layout = vk::raii::PipelineLayout(
        device.handle(), vk::PipelineLayoutCreateInfo({}, 1, &*program.setLayout,
                                                      pushConstantBytes > 0 ? 1 : 0, &push));
    program.pipeline = createPipeline(device, spirv, *program.layout, specialization);
    program_ = std::make_shared<const Program>(std::move(program));
    resources_.emplace(device, *program_->setLayout, resources);
  } catch (const vk::SystemError& error) {
    throw DeviceError(
        fmt::format("device {} cannot build a compute kernel: {}", device.name(), error.what()));
  }
}

ComputeKernel::ComputeKernel(const Device& device, const ComputeKernel& like,
                             const std::vector<KernelResource>& resources)
    : program_(like.program_) {
  try {
    resources_.emplace(device, *program_->setLayout, resources);
  } catch (const vk::SystemError& error) {
    throw DeviceError(
        fmt::format("device {} cannot bind a kernel's buffers: {}", device.name(), error.what()));
  }
}

}  // namespace morphgrid
