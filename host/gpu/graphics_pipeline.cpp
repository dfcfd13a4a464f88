#include "gpu/graphics_pipeline.h"

#include <fmt/format.h>

#include <array>

#include "core/error.h"
#include "gpu/vulkan_commands.h"
#include "gpu/vulkan_pass.h"

namespace morphgrid {
namespace {

constexpr auto kPushStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

vk::raii::ShaderModule createModule(const Device& device, ShaderCode spirv) {
  return {device.handles().device,
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
                                  vk::PipelineLayout layout, const DrawPass::Handles& pass,
                                  Blending blending, Primitive primitive) {
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
  const vk::PipelineMultisampleStateCreateInfo multisample({}, pass.samples);
  const vk::PipelineDepthStencilStateCreateInfo depth({}, VK_TRUE, blending == Blending::opaque,
                                                      vk::CompareOp::eLess);
  const auto attachment = attachmentOf(blending);
  const vk::PipelineColorBlendStateCreateInfo blend({}, VK_FALSE, vk::LogicOp::eCopy, attachment);
  const std::array dynamic = {vk::DynamicState::eViewport, vk::DynamicState::eScissor};
  const vk::PipelineDynamicStateCreateInfo dynamicState({}, dynamic);
  return {device.handles().device, nullptr,
          vk::GraphicsPipelineCreateInfo({}, stages, &vertexInput, &assembly, nullptr, &viewport,
                                         &rasterization, &multisample, &depth, &blend,
                                         &dynamicState, layout, *pass.renderPass)};
}

}  // namespace

struct GraphicsPipeline::Handles {
  vk::raii::PipelineLayout layout;
  vk::raii::Pipeline pipeline;
};

GraphicsPipeline::GraphicsPipeline(const Device& device, const ShaderPair& shaders,
                                   const std::vector<ResourceSlot>& slots,
                                   std::uint32_t pushConstantBytes, const DrawPass& pass,
                                   Blending blending, Primitive primitive)
    : resourceLayout_(device, slots, ShaderStage::vertex) {
  try {
    const vk::DescriptorSetLayout set = resourceLayout_.handle();
    const vk::PushConstantRange push(kPushStages, 0, pushConstantBytes);
    vk::raii::PipelineLayout layout(device.handles().device,
                                    vk::PipelineLayoutCreateInfo({}, set, push));
    vk::raii::Pipeline pipeline =
        createPipeline(device, shaders, *layout, pass.handles(), blending, primitive);
    handles_ = std::make_shared<const Handles>(Handles{std::move(layout), std::move(pipeline)});
  } catch (const vk::SystemError& error) {
    throw DeviceError(
        fmt::format("device {} cannot build a graphics pipeline: {}", device.name(), error.what()));
  }
}

void GraphicsPipeline::bind(const CommandBuffer& commands, const ResourceSet& resources) const {
  const vk::DescriptorSet set = resources.handle();
  commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *handles_->pipeline);
  commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *handles_->layout, 0, set, {});
}

void GraphicsPipeline::drawBytes(const CommandBuffer& commands, const void* push,
                                 std::uint32_t pushBytes, std::uint32_t vertexCount) const {
  commands.pushConstants<std::byte>(
      *handles_->layout, kPushStages, 0,
      vk::ArrayProxy<const std::byte>(pushBytes, static_cast<const std::byte*>(push)));
  commands.draw(vertexCount, 1, 0, 0);
}

}  // namespace morphgrid
