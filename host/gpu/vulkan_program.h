#pragma once
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "gpu/resource_set.h"
#include "gpu/shader_code.h"
#include "gpu/vulkan_device.h"

namespace morphgrid {

/// A compute shader on its way to the device.
struct KernelProgram {
  const char* name;  ///< The name of its source file.
  ResourceLayout resources;
  vk::raii::PipelineLayout layout;
  /// Compiled on a thread of its own. get() throws DeviceError when the device refuses.
  std::shared_future<vk::raii::Pipeline> pipeline;
};

/// The compute shaders of a device: each is compiled when it is first asked for, all at the same
/// time, as that costs more than a small solve.
class KernelPrograms {
 public:
  /// spirv: static data, known by its address. specialization: the values of constant_id 0, 1, ...
  std::shared_ptr<const KernelProgram> find(const Device& device, ShaderCode spirv,
                                            const std::vector<ResourceSlot>& slots,
                                            std::uint32_t pushConstantBytes,
                                            const std::vector<std::uint32_t>& specialization);

  /// See tellSlowCompile().
  void onSlowCompile(std::function<void()> tell) { onSlowCompile_ = std::move(tell); }

  /// Waits until it is compiled. Throws DeviceError when the device refuses.
  vk::Pipeline await(const KernelProgram& program);

 private:
  using Key =
      std::tuple<const std::uint32_t*, std::vector<ResourceSlot>, std::vector<std::uint32_t>>;
  std::map<Key, std::shared_ptr<const KernelProgram>> programs_;
  std::function<void()> onSlowCompile_;  ///< Empty once it was called.
};

}  // namespace morphgrid
