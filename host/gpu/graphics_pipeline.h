#pragma once

#include "gpu/resource_set.h"
#include "gpu/shader_code.h"

namespace morphgrid {

struct ShaderPair {
  ShaderCode vertex;
  ShaderCode fragment;
  std::vector<std::uint32_t> constants = {};  ///< Values of constant_id 0, 1, ... of both.
};

enum class Blending {
  opaque,
  translucent,  ///< By alpha, over what is there; hides nothing that is drawn later.
};

enum class Primitive {
  triangles,
  frontTriangles,  ///< Those that are counter-clockwise in the picture: closed bodies need no more.
  lines,
};

/// Draws triangles or lines of a pixel's width, with a depth test. There are no
/// vertex attributes: the vertex shader makes everything from gl_VertexIndex and its resources.
/// Push constants reach both shaders.
class GraphicsPipeline {
 public:
  /// slots: what the vertex shader reads. Throws DeviceError when the device refuses.
  GraphicsPipeline(const Device& device, const ShaderPair& shaders,
                   const std::vector<ResourceSlot>& slots, std::uint32_t pushConstantBytes,
                   vk::RenderPass renderPass, vk::SampleCountFlagBits samples,
                   Blending blending = Blending::opaque,
                   Primitive primitive = Primitive::triangles);

  vk::DescriptorSetLayout setLayout() const { return *setLayout_; }

  /// Records what draw() needs; inside the render pass.
  void bind(const vk::raii::CommandBuffer& commands, const ResourceSet& resources) const;

  template <typename Push>
  void draw(const vk::raii::CommandBuffer& commands, const Push& push,
            std::uint32_t vertexCount) const {
    commands.pushConstants<Push>(*layout_, kPushStages, 0, push);
    commands.draw(vertexCount, 1, 0, 0);
  }

 private:
  static constexpr auto kPushStages =
      vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

  vk::raii::DescriptorSetLayout setLayout_ = nullptr;
  vk::raii::PipelineLayout layout_ = nullptr;
  vk::raii::Pipeline pipeline_ = nullptr;
};

}  // namespace morphgrid
