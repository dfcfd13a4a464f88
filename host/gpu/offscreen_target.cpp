#include "gpu/offscreen_target.h"

namespace morphgrid {
namespace {

constexpr vk::Format kColorFormat = vk::Format::eR8G8B8A8Unorm;
constexpr vk::DeviceSize kBytesPerPixel = 4;
constexpr auto kReadBack = vk::ImageLayout::eTransferSrcOptimal;

}  // namespace

OffscreenTarget::OffscreenTarget(const Device& device, std::uint32_t width, std::uint32_t height,
                                 std::uint32_t wantedSamples)
    : pass_(device, {kColorFormat, wantedSamples, kReadBack}),
      color_(device, width, height, kColorFormat, vk::SampleCountFlagBits::e1,
             vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferSrc),
      canvas_(device, pass_, width, height, {color_.view()}),
      pixels_(device, kBytesPerPixel * width * height, vk::BufferUsageFlagBits::eTransferDst,
              MemoryKind::host),
      stream_(device) {}

void OffscreenTarget::recordReadBack() {
  const vk::BufferImageCopy region(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {},
                                   {width(), height(), 1});
  stream_.commands().copyImageToBuffer(color_.handle(), kReadBack, pixels_.handle(), region);
}

std::vector<std::uint8_t> OffscreenTarget::render(
    const std::function<void(const vk::raii::CommandBuffer&)>& draw) {
  stream_.begin();
  canvas_.record(stream_.commands(), 0, draw);
  recordReadBack();
  stream_.end();
  stream_.submitAndWait();
  const auto bytes = pixels_.mapped<std::uint8_t>();
  return {bytes.begin(), bytes.end()};
}

}  // namespace morphgrid
