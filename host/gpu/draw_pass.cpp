#include "gpu/draw_pass.h"

#include <array>
#include <cassert>
#include <optional>

#include "gpu/vulkan_commands.h"
#include "gpu/vulkan_pass.h"

namespace morphgrid {
namespace {

using Usage = vk::ImageUsageFlagBits;
using Layout = vk::ImageLayout;
using Stage = vk::PipelineStageFlagBits;
using Access = vk::AccessFlagBits;

vk::SampleCountFlagBits chooseSamples(const Device& device, std::uint32_t wanted) {
  const vk::PhysicalDeviceLimits& limits = device.handles().properties.limits;
  const auto counts = limits.framebufferColorSampleCounts & limits.framebufferDepthSampleCounts;
  const bool four = wanted >= 4 && (counts & vk::SampleCountFlagBits::e4);
  return four ? vk::SampleCountFlagBits::e4 : vk::SampleCountFlagBits::e1;
}

/// Vulkan promises 16 bits and, of the finer formats, at least one of two.
vk::Format chooseDepthFormat(const Device& device) {
  const auto tiling =
      device.handles().physical.getFormatProperties(vk::Format::eD32Sfloat).optimalTilingFeatures;
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
  const vk::Format format = vulkanFormat(options.format);
  const Layout finalLayout = options.nextUse == NextUse::copied ? Layout::eTransferSrcOptimal
                                                                : Layout::eColorAttachmentOptimal;
  using Load = vk::AttachmentLoadOp;
  using Store = vk::AttachmentStoreOp;
  const bool resolve = samples != vk::SampleCountFlagBits::e1;
  std::vector attachments = {
      attachmentOf(format, samples, Load::eClear, resolve ? Store::eDontCare : Store::eStore,
                   resolve ? Layout::eColorAttachmentOptimal : finalLayout),
      attachmentOf(depthFormat, samples, Load::eClear, Store::eDontCare,
                   Layout::eDepthStencilAttachmentOptimal)};
  if (resolve) {
    attachments.push_back(attachmentOf(format, vk::SampleCountFlagBits::e1, Load::eDontCare,
                                       Store::eStore, finalLayout));
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
  return {device.handles().device,
          vk::RenderPassCreateInfo({}, attachments, subpass, dependencies)};
}

std::shared_ptr<const DrawPass::Handles> createPass(const Device& device,
                                                    const DrawPassOptions& options) {
  const vk::SampleCountFlagBits samples = chooseSamples(device, options.samples);
  const vk::Format depthFormat = chooseDepthFormat(device);
  return std::make_shared<const DrawPass::Handles>(
      DrawPass::Handles{vulkanFormat(options.format), depthFormat, samples,
                        createRenderPass(device, options, depthFormat, samples)});
}

std::optional<Attachment> createMultisampled(const Device& device, const DrawPass::Handles& pass,
                                             PixelSize size) {
  if (pass.samples == vk::SampleCountFlagBits::e1) {
    return std::nullopt;
  }
  return Attachment(device, size, pass.format, pass.samples,
                    Usage::eColorAttachment | Usage::eTransientAttachment);
}

}  // namespace

vk::Format vulkanFormat(ColorFormat format) {
  return format == ColorFormat::rgba8 ? vk::Format::eR8G8B8A8Unorm : vk::Format::eB8G8R8A8Unorm;
}

DrawPass::DrawPass(const Device& device, const DrawPassOptions& options)
    : handles_(createPass(device, options)) {}

std::uint32_t DrawPass::samples() const { return static_cast<std::uint32_t>(handles_->samples); }

void setViewport(const CommandBuffer& commands, const Viewport& viewport) {
  commands.setViewport(
      0, vk::Viewport(viewport.left, viewport.top, viewport.width, viewport.height, 0, 1));
}

struct Canvas::Handles {
  vk::RenderPass renderPass;
  std::optional<Attachment> multisampled;  ///< Only where a pixel has several samples.
  Attachment depth;
  std::vector<vk::raii::Framebuffer> framebuffers;
};

Canvas::Canvas(const Device& device, const DrawPass& pass, PixelSize size,
               const std::vector<VkImageView>& images)
    : size_(size) {
  assert(size.width > 0 && size.height > 0);
  const DrawPass::Handles& how = pass.handles();
  Handles handles{*how.renderPass,
                  createMultisampled(device, how, size),
                  Attachment(device, size, how.depthFormat, how.samples,
                             Usage::eDepthStencilAttachment | Usage::eTransientAttachment),
                  {}};
  for (const vk::ImageView image : images) {
    std::vector<vk::ImageView> views = {image, handles.depth.view()};
    if (handles.multisampled) {
      views = {handles.multisampled->view(), handles.depth.view(), image};
    }
    handles.framebuffers.emplace_back(
        device.handles().device,
        vk::FramebufferCreateInfo({}, *how.renderPass, views, size.width, size.height, 1));
  }
  handles_ = std::make_shared<const Handles>(std::move(handles));
}

void Canvas::record(const CommandBuffer& commands, std::size_t image,
                    const std::function<void(const CommandBuffer&)>& draw) const {
  const std::array<vk::ClearValue, 2> clear = {
      vk::ClearColorValue(std::array<float, 4>{1, 1, 1, 1}), vk::ClearDepthStencilValue(1, 0)};
  const vk::Rect2D area({0, 0}, {size_.width, size_.height});
  commands.beginRenderPass(
      vk::RenderPassBeginInfo(handles_->renderPass, *handles_->framebuffers.at(image), area, clear),
      vk::SubpassContents::eInline);
  setViewport(commands, {0, 0, static_cast<float>(size_.width), static_cast<float>(size_.height)});
  commands.setScissor(0, area);
  draw(commands);
  commands.endRenderPass();
}

}  // namespace morphgrid
