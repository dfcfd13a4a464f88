#include "gpu/vulkan_program.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "core/error.h"
#include "gpu/slow_compile.h"

namespace morphgrid {
namespace {

vk::raii::Pipeline createPipeline(const Device& device, ShaderCode spirv, vk::PipelineLayout layout,
                                  const std::vector<std::uint32_t>& specialization) try {
  const vk::raii::ShaderModule module(
      device.handles().device,
      vk::ShaderModuleCreateInfo({}, spirv.words.size_bytes(), spirv.words.data()));
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
  // Where a window shares the device, CommandStream cuts dispatches.
  const vk::PipelineCreateFlags flags =
      device.pace() ? vk::PipelineCreateFlagBits::eDispatchBase : vk::PipelineCreateFlags();
  return {device.handles().device, nullptr, vk::ComputePipelineCreateInfo(flags, stage, layout)};
} catch (const vk::SystemError& error) {
  throw DeviceError(
      fmt::format("device {} cannot build a compute kernel: {}", device.name(), error.what()));
}

KernelProgram compile(const Device& device, ShaderCode spirv,
                      const std::vector<ResourceSlot>& slots, std::uint32_t pushConstantBytes,
                      const std::vector<std::uint32_t>& specialization) try {
  ResourceLayout resources(device, slots, ShaderStage::compute);
  const vk::DescriptorSetLayout set = resources.handle();
  const vk::PushConstantRange push(vk::ShaderStageFlagBits::eCompute, 0, pushConstantBytes);
  vk::raii::PipelineLayout layout(
      device.handles().device,
      vk::PipelineLayoutCreateInfo({}, 1, &set, pushConstantBytes > 0 ? 1 : 0, &push));
  auto pipeline = std::async([&device, spirv, layout = *layout, specialization] {
    return createPipeline(device, spirv, layout, specialization);
  });
  return {spirv.name, std::move(resources), std::move(layout), std::move(pipeline)};
} catch (const vk::SystemError& error) {
  throw DeviceError(
      fmt::format("device {} cannot build a compute kernel: {}", device.name(), error.what()));
}

}  // namespace

void tellSlowCompile(const Device& device, std::function<void()> tell) {
  device.programs().onSlowCompile(std::move(tell));
}

std::shared_ptr<const KernelProgram> KernelPrograms::find(
    const Device& device, ShaderCode spirv, const std::vector<ResourceSlot>& slots,
    std::uint32_t pushConstantBytes, const std::vector<std::uint32_t>& specialization) {
  std::shared_ptr<const KernelProgram>& program =
      programs_[Key(spirv.words.data(), slots, specialization)];
  if (!program) {
    program = std::make_shared<const KernelProgram>(
        compile(device, spirv, slots, pushConstantBytes, specialization));
  }
  return program;
}

vk::Pipeline KernelPrograms::await(const KernelProgram& program) {
  constexpr std::chrono::seconds kPatience(1);
  if (onSlowCompile_ && program.pipeline.wait_for(kPatience) == std::future_status::timeout) {
    std::exchange(onSlowCompile_, {})();
  }
  return *program.pipeline.get();
}

}  // namespace morphgrid
