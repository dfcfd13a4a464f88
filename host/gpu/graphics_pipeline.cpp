#include "gpu/graphics_pipeline.h"

#include <fmt/format.h>

#include <array>

#include "core/error.h"

namespace morphgrid {
namespace {

vk::raii::ShaderModule createModule(const Device& device, ShaderCode spirv) {
  return {device.handle(),
          vk::ShaderModuleCreateInfo({}, spirv.words.size_bytes(), spirv.words.data())};
}

vk::PipelineColorBlendAttachmentState attachmentOf(Blending blending) {
  using Component = vk::ColorComponentFlagBits;
  using Factor = vk::BlendFactor;
  // The image's own alpha stays what it was: where it is opaque it remains so.
  vk::PipelineColorBlendAttachmentState state(blending == Blending::translucent, Factor::eSrcAlpha,
                                              Factor::eOneMinusSrcAlpha, vk::BlendOp::eAdd,
                                              Factor::eZero, Factor::eOne, vk::BlendOp::eAdd);
  state.colorWriteMask = Component::eR | Component::eG | Component::eB | Component::eA;
  return state;
}

vk::raii::Pipeline createPipeline(const Device& device, const ShaderPair& shaders,
                                  vk::PipelineLayout layout, vk::RenderPass renderPass,
                                  vk::SampleCountFlagBits samples, Blending blending,
                                  Primitive primitive) {
  using Stage = vk::ShaderStageFlagBits;
  const vk::raii::ShaderModule vertex = createModule(device, shaders.vertex);
  const vk::raii::ShaderModule fragment = createModule(device, shaders.fragment);
  std::vector<vk::SpecializationMapEntry> entries;
  for (std::uint32_t n = 0; n < shaders.constants.size(); ++n) {
    entries.emplace_back(n, static_cast<std::uint32_t>(n * sizeof(std::uint32_t)),
                         sizeof(std::uint32_t));
  }
  const vk::SpecializationInfo constants(static_cast<std::uint32_t>(entries.size()), entries.data(),
                                         shaders.constants.size() * sizeof(std::uint32_t),
                                         shaders.constants.data());
  const std::array stages = {
      vk::PipelineShaderStageCreateInfo({}, Stage::eVertex, *vertex, "main", &constants),
      vk::PipelineShaderStageCreateInfo({}, Stage::eFragment, *fragment, "main", &constants)};
  const vk::PipelineVertexInputStateCreateInfo vertexInput;
  const vk::PipelineInputAssemblyStateCreateInfo assembly(
      {}, primitive == Primitive::lines ? vk::PrimitiveTopology::eLineList
                                        : vk::PrimitiveTopology::eTriangleList);
  const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
  vk::PipelineRasterizationStateCreateInfo rasterization;
  if (primitive == Primitive::frontTriangles) {
    rasterization.cullMode = vk::CullModeFlagBits::eBack;
  }
  rasterization.lineWidth = 1;  // Validation wants it even without lines.
  const vk::PipelineMultisampleStateCreateInfo multisample({}, samples);
  const vk::PipelineDepthStencilStateCreateInfo depth({}, VK_TRUE, blending == Blending::opaque,
                                                      vk::CompareOp::eLess);
  const auto attachment = attachmentOf(blending);
  const vk::PipelineColorBlendStateCreateInfo blend({}, VK_FALSE, vk::LogicOp::eCopy, attachment);
  const std::array dynamic = {vk::DynamicState::eViewport, vk::DynamicState::eScissor};
  const vk::PipelineDynamicStateCreateInfo dynamicState({}, dynamic);
  return {device.handle(), nullptr,
          vk::GraphicsPipelineCreateInfo({}, stages, &vertexInput, &assembly, nullptr, &viewport,
                                         &rasterization, &multisample, &depth, &blend,
                                         &dynamicState, layout, renderPass)};
}

}  // namespace

GraphicsPipeline::GraphicsPipeline(const Device& device, const ShaderPair& shaders,
                                   const std::vector<ResourceSlot>& slots,
                                   std::uint32_t pushConstantBytes, vk::RenderPass renderPass,
                                   vk::SampleCountFlagBits samples, Blending blending,
                                   Primitive primitive) {
  try {
    setLayout_ = createSetLayout(device, slots, vk::ShaderStageFlagBits::eVertex);
    const vk::PushConstantRange push(kPushStages, 0, pushConstantBytes);
    layout_ = vk::raii::PipelineLayout(device.handle(),
                                       vk::PipelineLayoutCreateInfo({}, *setLayout_, push));
    pipeline_ = createPipeline(device, shaders, *layout_, renderPass, samples, blending, primitive);
  } catch (const vk::SystemError& error) {
    throw DeviceError(
        fmt::format("device {} cannot build a graphics pipeline: {}", device.name(), error.what()));
  }
}

void GraphicsPipeline::bind(const vk::raii::CommandBuffer& commands,
                            const ResourceSet& resources) const {
  commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline_);
  commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout_, 0, resources.handle(),
                              {});
}

}  // namespace morphgrid
