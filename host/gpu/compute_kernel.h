#pragma once
#include <optional>
#include <span>

#include "gpu/resource_set.h"

namespace morphgrid {

/// A compute shader with its resources bound: ready to be dispatched.
/// The resources must outlive it.
class ComputeKernel {
 public:
  /// specialization: the values of constant_id 0, 1, ... Throws DeviceError when the device
  /// refuses.
  ComputeKernel(const Device& device, std::span<const std::uint32_t> spirv,
                const std::vector<KernelResource>& resources, std::uint32_t pushConstantBytes,
                const std::vector<std::uint32_t>& specialization = {});

  vk::Pipeline pipeline() const { return *pipeline_; }
  vk::PipelineLayout layout() const { return *layout_; }
  vk::DescriptorSet descriptorSet() const { return resources_->handle(); }

 private:
  vk::raii::DescriptorSetLayout setLayout_ = nullptr;
  vk::raii::PipelineLayout layout_ = nullptr;
  vk::raii::Pipeline pipeline_ = nullptr;
  std::optional<ResourceSet> resources_;
};

}  // namespace morphgrid
