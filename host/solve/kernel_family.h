#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "gpu/compute_kernel.h"

namespace morphgrid {

/// One compute shader, compiled once, for several sets of resources.
class KernelFamily {
 public:
  /// spirv: static data, as ComputeKernel takes it.
  KernelFamily(const Device& device, ShaderCode spirv, std::uint32_t pushConstantBytes,
               std::vector<std::uint32_t> specialization)
      : device_(device),
        spirv_(spirv),
        pushConstantBytes_(pushConstantBytes),
        specialization_(std::move(specialization)) {}

  /// Compiles at the first call. The resources must outlive the kernel.
  ComputeKernel bind(const std::vector<KernelResource>& resources) {
    if (!first_) {
      first_.emplace(device_, spirv_, resources, pushConstantBytes_, specialization_);
    }
    return {device_, *first_, resources};
  }

 private:
  const Device& device_;
  ShaderCode spirv_;
  std::uint32_t pushConstantBytes_;
  std::vector<std::uint32_t> specialization_;
  std::optional<ComputeKernel> first_;  ///< Never dispatched.
};

}  // namespace morphgrid
