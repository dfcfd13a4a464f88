#include "gpu/compute_kernel.h"

#include "gpu/vulkan_program.h"

namespace morphgrid {

ComputeKernel::ComputeKernel(const Device& device, ShaderCode spirv,
                             const std::vector<KernelResource>& resources,
                             std::uint32_t pushConstantBytes,
                             const std::vector<std::uint32_t>& specialization)
    : program_(device.programs().find(device, spirv, slotsOf(resources), pushConstantBytes,
                                      specialization)),
      resources_(device, program_->resources, resources) {}

ComputeKernel::ComputeKernel(const Device& device, const ComputeKernel& like,
                             const std::vector<KernelResource>& resources)
    : program_(like.program_), resources_(device, program_->resources, resources) {}

const char* ComputeKernel::name() const { return program_->name; }

}  // namespace morphgrid
