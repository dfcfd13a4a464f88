#pragma once
#include <memory>

#include "gpu/resource_set.h"
#include "gpu/shader_code.h"

namespace morphgrid {

struct KernelProgram;  // gpu/vulkan_program.h

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

  const char* name() const;
  const KernelProgram& program() const { return *program_; }
  const ResourceSet& resources() const { return resources_; }

 private:
  std::shared_ptr<const KernelProgram> program_;
  ResourceSet resources_;
};

}  // namespace morphgrid
