#pragma once
#include <span>
#include <variant>
#include <vector>

#include "gpu/buffer.h"

namespace morphgrid {

/// What a kernel reads or writes at a binding number: a storage buffer or a view of texels.
struct KernelResource {
  std::uint32_t binding;
  std::variant<const Buffer*, const TexelView*> resource;

  vk::DescriptorType type() const;
};

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
  vk::DescriptorSet descriptorSet() const { return *set_; }

 private:
  vk::raii::DescriptorSetLayout setLayout_ = nullptr;
  vk::raii::PipelineLayout layout_ = nullptr;
  vk::raii::Pipeline pipeline_ = nullptr;
  vk::raii::DescriptorPool pool_ = nullptr;
  vk::raii::DescriptorSet set_ = nullptr;
};

}  // namespace morphgrid
