#include "gpu/offscreen_target.h"

#include "gpu/vulkan_attachment.h"
#include "gpu/vulkan_commands.h"
#include "gpu/vulkan_pass.h"

namespace morphgrid {
namespace {

constexpr std::uint64_t kBytesPerPixel = 4;

}  // namespace

OffscreenTarget::OffscreenTarget(const Device& device, std::uint32_t width, std::uint32_t height,
                                 std::uint32_t wantedSamples)
    : pass_(device, {ColorFormat::rgba8, wantedSamples, NextUse::copied}),
      color_(std::make_shared<const Attachment>(
          device, PixelSize{width, height}, pass_.handles().format, vk::SampleCountFlagBits::e1,
          vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferSrc)),
      canvas_(device, pass_, {width, height}, {color_->view()}),
      pixels_(device, kBytesPerPixel * width * height, BufferUsage::transferDst, MemoryKind::host),
      stream_(device) {}

void OffscreenTarget::recordReadBack() {
  const vk::BufferImageCopy region(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {},
                                   {size().width, size().height, 1});
  stream_.commands().copyImageToBuffer(color_->handle(), vk::ImageLayout::eTransferSrcOptimal,
                                       vk::Buffer(pixels_.handle()), region);
}

std::vector<std::uint8_t> OffscreenTarget::render(
    const std::function<void(const CommandBuffer&)>& draw) {
  stream_.begin();
  canvas_.record(stream_.commands(), 0, draw);
  recordReadBack();
  stream_.end();
  stream_.submitAndWait();
  const auto bytes = pixels_.mapped<std::uint8_t>();
  return {bytes.begin(), bytes.end()};
}

}  // namespace morphgrid
