#include "render/webp_animation.h"

#include <fmt/format.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <cassert>
#include <new>
#include <string_view>

#include "core/atomic_file.h"
#include "core/error.h"

namespace morphgrid {
namespace {

// Lines stay crisp, and a file is a tenth of what lossless takes.
constexpr float kQuality = 60;
// libwebp counts from 0 (quick) to 6; beyond this files hardly shrink.
constexpr int kEffort = 4;

struct WebpPicture : WebPPicture {
  explicit WebpPicture(const Image& image) : WebPPicture{} {
    WebPPictureInit(this);
    use_argb = 1;
    width = image.width;
    height = image.height;
    if (WebPPictureImportRGBX(this, image.rgba.data(), 4 * image.width) == 0) {
      throw std::bad_alloc();
    }
  }
  ~WebpPicture() { WebPPictureFree(this); }
  WebpPicture(const WebpPicture&) = delete;
  WebpPicture& operator=(const WebpPicture&) = delete;
};

struct WebpBytes : WebPData {
  WebpBytes() : WebPData{} { WebPDataInit(this); }
  ~WebpBytes() { WebPDataClear(this); }
  WebpBytes(const WebpBytes&) = delete;
  WebpBytes& operator=(const WebpBytes&) = delete;
};

WebPConfig packing() {
  WebPConfig config;
  WebPConfigInit(&config);
  config.quality = kQuality;
  config.method = kEffort;
  config.use_sharp_yuv = 1;  // Else thin coloured lines lose their colour.
  return config;
}

[[noreturn]] void refusePacking(const std::string& what, WebPAnimEncoder* encoder) {
  throw InputError(fmt::format("{}: {}", what, WebPAnimEncoderGetError(encoder)));
}

}  // namespace

void WebpAnimation::Deleter::operator()(WebPAnimEncoder* encoder) const {
  WebPAnimEncoderDelete(encoder);
}

WebpAnimation::WebpAnimation(int width, int height)
    : width_(width), height_(height), encoder_(WebPAnimEncoderNew(width, height, nullptr)) {
  assert(width >= 1 && width <= kLargestSide && height >= 1 && height <= kLargestSide);
  if (!encoder_) {
    throw std::bad_alloc();
  }
}

void WebpAnimation::add(const Image& frame, int milliseconds) {
  assert(frame.width == width_ && frame.height == height_ && milliseconds > 0);
  WebpPicture picture(frame);
  const WebPConfig config = packing();
  if (WebPAnimEncoderAdd(encoder_.get(), &picture, milliseconds_, &config) == 0) {
    refusePacking("a frame cannot be packed as WebP", encoder_.get());
  }
  milliseconds_ += milliseconds;
}

void WebpAnimation::write(const std::filesystem::path& path) {
  WebpBytes bytes;
  if (WebPAnimEncoderAdd(encoder_.get(), nullptr, milliseconds_, nullptr) == 0 ||
      WebPAnimEncoderAssemble(encoder_.get(), &bytes) == 0) {
    refusePacking(fmt::format("{}: the animation cannot be packed", path.string()), encoder_.get());
  }
  writeFileAtomically(path,
                      std::string_view(reinterpret_cast<const char*>(bytes.bytes), bytes.size));
}

}  // namespace morphgrid
