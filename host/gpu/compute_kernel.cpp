#include "gpu/compute_kernel.h"

#include <fmt/format.h>

#include "core/error.h"

namespace morphgrid {
ComputeKernel::ComputeKernel(const Device& device, ShaderCode spirv,
                             const std::vector<KernelResource>& resources,
                             std::uint32_t pushConstantBytes,
                             const std::vector<std::uint32_t>& specialization) {
  try {
    program_ = device.programs().find(device, spirv, slotsOf(resources), pushConstantBytes,
                                      specialization);
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
