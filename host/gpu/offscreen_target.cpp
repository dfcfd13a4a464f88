#include "gpu/offscreen_target.h"

#include <array>
#include <cassert>

namespace morphgrid {
namespace {

using Usage = vk::ImageUsageFlagBits;
using Layout = vk::ImageLayout;
using Stage = vk::PipelineStageFlagBits;
using Access = vk::AccessFlagBits;

constexpr vk::Format kColorFormat = vk::Format::eR8G8B8A8Unorm;
constexpr vk::DeviceSize kBytesPerPixel = 4;

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
std::vector<vk::AttachmentDescription> attachmentsOf(vk::Format depthFormat,
                                                     vk::SampleCountFlagBits samples) {
  using Load = vk::AttachmentLoadOp;
  using Store = vk::AttachmentStoreOp;
  const bool resolve = samples != vk::SampleCountFlagBits::e1;
  std::vector attachments = {
      attachmentOf(kColorFormat, samples, Load::eClear, resolve ? Store::eDontCare : Store::eStore,
                   resolve ? Layout::eColorAttachmentOptimal : Layout::eTransferSrcOptimal),
      attachmentOf(depthFormat, samples, Load::eClear, Store::eDontCare,
                   Layout::eDepthStencilAttachmentOptimal)};
  if (resolve) {
    attachments.push_back(attachmentOf(kColorFormat, vk::SampleCountFlagBits::e1, Load::eDontCare,
                                       Store::eStore, Layout::eTransferSrcOptimal));
  }
  return attachments;
}

/// The pass begins after the last picture's and what was computed for this one, and ends before the
/// read-back.
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
  const vk::SubpassDependency after(0, VK_SUBPASS_EXTERNAL, Stage::eColorAttachmentOutput,
                                    Stage::eTransfer, Access::eColorAttachmentWrite,
                                    Access::eTransferRead);
  return {before, after};
}

vk::raii::RenderPass createRenderPass(const Device& device, vk::Format depthFormat,
                                      vk::SampleCountFlagBits samples) {
  const auto attachments = attachmentsOf(depthFormat, samples);
  const vk::AttachmentReference color(0, Layout::eColorAttachmentOptimal);
  const vk::AttachmentReference depth(1, Layout::eDepthStencilAttachmentOptimal);
  const vk::AttachmentReference resolved(2, Layout::eColorAttachmentOptimal);
  const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, 0, nullptr, 1, &color,
                                       attachments.size() > 2 ? &resolved : nullptr, &depth);
  const auto dependencies = passDependencies();
  return {device.handle(), vk::RenderPassCreateInfo({}, attachments, subpass, dependencies)};
}

std::optional<Attachment> createMultisampled(const Device& device, std::uint32_t width,
                                             std::uint32_t height,
                                             vk::SampleCountFlagBits samples) {
  if (samples == vk::SampleCountFlagBits::e1) {
    return std::nullopt;
  }
  return Attachment(device, width, height, kColorFormat, samples,
                    Usage::eColorAttachment | Usage::eTransientAttachment);
}

}  // namespace

OffscreenTarget::OffscreenTarget(const Device& device, std::uint32_t width, std::uint32_t height,
                                 std::uint32_t wantedSamples)
    : width_(width),
      height_(height),
      samples_(chooseSamples(device, wantedSamples)),
      depthFormat_(chooseDepthFormat(device)),
      multisampled_(createMultisampled(device, width, height, samples_)),
      color_(device, width, height, kColorFormat, vk::SampleCountFlagBits::e1,
             Usage::eColorAttachment | Usage::eTransferSrc),
      depth_(device, width, height, depthFormat_, samples_,
             Usage::eDepthStencilAttachment | Usage::eTransientAttachment),
      renderPass_(createRenderPass(device, depthFormat_, samples_)),
      framebuffer_(createFramebuffer(device)),
      pixels_(device, kBytesPerPixel * width * height, vk::BufferUsageFlagBits::eTransferDst,
              MemoryKind::host),
      stream_(device) {
  assert(width > 0 && height > 0);
}

vk::raii::Framebuffer OffscreenTarget::createFramebuffer(const Device& device) const {
  std::vector<vk::ImageView> views = {color_.view(), depth_.view()};
  if (multisampled_) {
    views = {multisampled_->view(), depth_.view(), color_.view()};
  }
  return {device.handle(), vk::FramebufferCreateInfo({}, *renderPass_, views, width_, height_, 1)};
}

void OffscreenTarget::recordPass(const std::function<void(const vk::raii::CommandBuffer&)>& draw) {
  const auto& commands = stream_.commands();
  const std::array<vk::ClearValue, 2> clear = {
      vk::ClearColorValue(std::array<float, 4>{1, 1, 1, 1}), vk::ClearDepthStencilValue(1, 0)};
  const vk::Rect2D area({0, 0}, {width_, height_});
  commands.beginRenderPass(vk::RenderPassBeginInfo(*renderPass_, *framebuffer_, area, clear),
                           vk::SubpassContents::eInline);
  commands.setViewport(
      0, vk::Viewport(0, 0, static_cast<float>(width_), static_cast<float>(height_), 0, 1));
  commands.setScissor(0, area);
  draw(commands);
  commands.endRenderPass();
}

void OffscreenTarget::recordReadBack() {
  const vk::BufferImageCopy region(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {},
                                   {width_, height_, 1});
  stream_.commands().copyImageToBuffer(color_.handle(), Layout::eTransferSrcOptimal,
                                       pixels_.handle(), region);
}

std::vector<std::uint8_t> OffscreenTarget::render(
    const std::function<void(const vk::raii::CommandBuffer&)>& draw) {
  stream_.begin();
  recordPass(draw);
  recordReadBack();
  stream_.end();
  stream_.submitAndWait();
  const auto bytes = pixels_.mapped<std::uint8_t>();
  return {bytes.begin(), bytes.end()};
}

}  // namespace morphgrid
