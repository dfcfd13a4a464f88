#pragma once
#include <memory>
#include <optional>

#include "gpu/kernel_program.h"

namespace morphgrid {

/// A compute shader with its resources bound: ready to be dispatched.
/// The resources must outlive it.
class ComputeKernel {
 public:
  /// spirv: static data. specialization: the values of constant_id 0, 1, ... The shader is compiled
  /// on another thread. Throws DeviceError when the device refuses.
  ComputeKernel(const Device& device, ShaderCode spirv,
                const std::vector<KernelResource>& resources, std::uint32_t pushConstantBytes,
                const std::vector<std::uint32_t>& specialization = {});

  /// The same shader with other resources at the same bindings: it is compiled once.
  ComputeKernel(const Device& device, const ComputeKernel& like,
                const std::vector<KernelResource>& resources);

  const char* name() const { return program_->name; }
  /// Waits for the compiler. Throws DeviceError when it refuses.
  vk::Pipeline pipeline() const { return *program_->pipeline.get(); }
  vk::PipelineLayout layout() const { return *program_->layout; }
  vk::DescriptorSet descriptorSet() const { return resources_->handle(); }

 private:
  std::shared_ptr<const KernelProgram> program_;
  std::optional<ResourceSet> resources_;
};

}  // namespace morphgrid
