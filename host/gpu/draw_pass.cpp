#include "gpu/draw_pass.h"

#include <array>
#include <cassert>

namespace morphgrid {
namespace {

using Usage = vk::ImageUsageFlagBits;
using Layout = vk::ImageLayout;
using Stage = vk::PipelineStageFlagBits;
using Access = vk::AccessFlagBits;

vk::SampleCountFlagBits chooseSamples(const Device& device, std::uint32_t wanted) {
  const auto counts =
      device.limits().framebufferColorSampleCounts & device.limits().framebufferDepthSampleCounts;
  const bool four = wanted >= 4 && (counts & vk::SampleCountFlagBits::e4);
  return four ? vk::SampleCountFlagBits::e4 : vk::SampleCountFlagBits::e1;
}

/// Vulkan promises 16 bits and, of the finer formats, at least one of two.
vk::Format chooseDepthFormat(const Device& device) {
  const auto tiling =
      device.physical().getFormatProperties(vk::Format::eD32Sfloat).optimalTilingFeatures;
  return tiling & vk::FormatFeatureFlagBits::eDepthStencilAttachment
             ? vk::Format::eD32Sfloat
             : vk::Format::eX8D24UnormPack32;
}

vk::AttachmentDescription attachmentOf(vk::Format format, vk::SampleCountFlagBits samples,
                                       vk::AttachmentLoadOp load, vk::AttachmentStoreOp store,
                                       Layout finalLayout) {
  return {{},
          format,
          samples,
          load,
          store,
          vk::AttachmentLoadOp::eDontCare,
          vk::AttachmentStoreOp::eDontCare,
          Layout::eUndefined,
          finalLayout};
}

/// Attachments: what is drawn into, depth, and with several samples the resolved colour.
std::vector<vk::AttachmentDescription> attachmentsOf(const DrawPassOptions& options,
                                                     vk::Format depthFormat,
                                                     vk::SampleCountFlagBits samples) {
  using Load = vk::AttachmentLoadOp;
  using Store = vk::AttachmentStoreOp;
  const bool resolve = samples != vk::SampleCountFlagBits::e1;
  std::vector attachments = {
      attachmentOf(options.format, samples, Load::eClear,
                   resolve ? Store::eDontCare : Store::eStore,
                   resolve ? Layout::eColorAttachmentOptimal : options.finalLayout),
      attachmentOf(depthFormat, samples, Load::eClear, Store::eDontCare,
                   Layout::eDepthStencilAttachmentOptimal)};
  if (resolve) {
    attachments.push_back(attachmentOf(options.format, vk::SampleCountFlagBits::e1, Load::eDontCare,
                                       Store::eStore, options.finalLayout));
  }
  return attachments;
}

/// The pass begins after the last picture's and what was computed for this one. It ends before the
/// picture is read or drawn over, and before solvers write what its shaders read.
std::array<vk::SubpassDependency, 2> passDependencies() {
  const auto drawing =
      Stage::eColorAttachmentOutput | Stage::eEarlyFragmentTests | Stage::eLateFragmentTests;
  const auto written = Access::eColorAttachmentWrite | Access::eDepthStencilAttachmentWrite;
  const vk::SubpassDependency before(
      VK_SUBPASS_EXTERNAL, 0, drawing | Stage::eTransfer | Stage::eComputeShader,
      drawing | Stage::eVertexShader,
      written | Access::eTransferRead | Access::eTransferWrite | Access::eShaderWrite,
      written | Access::eColorAttachmentRead | Access::eDepthStencilAttachmentRead |
          Access::eShaderRead);
  const vk::SubpassDependency after(
      0, VK_SUBPASS_EXTERNAL, Stage::eColorAttachmentOutput | Stage::eVertexShader,
      Stage::eTransfer | Stage::eComputeShader | Stage::eColorAttachmentOutput,
      Access::eColorAttachmentWrite,
      Access::eTransferRead | Access::eColorAttachmentRead | Access::eColorAttachmentWrite);
  return {before, after};
}

vk::raii::RenderPass createRenderPass(const Device& device, const DrawPassOptions& options,
                                      vk::Format depthFormat, vk::SampleCountFlagBits samples) {
  const auto attachments = attachmentsOf(options, depthFormat, samples);
  const vk::AttachmentReference color(0, Layout::eColorAttachmentOptimal);
  const vk::AttachmentReference depth(1, Layout::eDepthStencilAttachmentOptimal);
  const vk::AttachmentReference resolved(2, Layout::eColorAttachmentOptimal);
  const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, 0, nullptr, 1, &color,
                                       attachments.size() > 2 ? &resolved : nullptr, &depth);
  const auto dependencies = passDependencies();
  return {device.handle(), vk::RenderPassCreateInfo({}, attachments, subpass, dependencies)};
}

std::optional<Attachment> createMultisampled(const Device& device, const DrawPass& pass,
                                             std::uint32_t width, std::uint32_t height) {
  if (pass.samples() == vk::SampleCountFlagBits::e1) {
    return std::nullopt;
  }
  return Attachment(device, width, height, pass.format(), pass.samples(),
                    Usage::eColorAttachment | Usage::eTransientAttachment);
}

}  // namespace

DrawPass::DrawPass(const Device& device, const DrawPassOptions& options)
    : format_(options.format),
      samples_(chooseSamples(device, options.samples)),
      depthFormat_(chooseDepthFormat(device)),
      renderPass_(createRenderPass(device, options, depthFormat_, samples_)) {}

Canvas::Canvas(const Device& device, const DrawPass& pass, std::uint32_t width,
               std::uint32_t height, const std::vector<vk::ImageView>& images)
    : renderPass_(pass.renderPass()),
      width_(width),
      height_(height),
      multisampled_(createMultisampled(device, pass, width, height)),
      depth_(device, width, height, pass.depthFormat(), pass.samples(),
             Usage::eDepthStencilAttachment | Usage::eTransientAttachment) {
  assert(width > 0 && height > 0);
  for (const vk::ImageView image : images) {
    std::vector<vk::ImageView> views = {image, depth_.view()};
    if (multisampled_) {
      views = {multisampled_->view(), depth_.view(), image};
    }
    framebuffers_.emplace_back(
        device.handle(), vk::FramebufferCreateInfo({}, pass.renderPass(), views, width, height, 1));
  }
}

void Canvas::record(const vk::raii::CommandBuffer& commands, std::size_t image,
                    const std::function<void(const vk::raii::CommandBuffer&)>& draw) const {
  const std::array<vk::ClearValue, 2> clear = {
      vk::ClearColorValue(std::array<float, 4>{1, 1, 1, 1}), vk::ClearDepthStencilValue(1, 0)};
  const vk::Rect2D area({0, 0}, {width_, height_});
  commands.beginRenderPass(
      vk::RenderPassBeginInfo(renderPass_, *framebuffers_.at(image), area, clear),
      vk::SubpassContents::eInline);
  commands.setViewport(
      0, vk::Viewport(0, 0, static_cast<float>(width_), static_cast<float>(height_), 0, 1));
  commands.setScissor(0, area);
  draw(commands);
  commands.endRenderPass();
}

}  // namespace morphgrid
