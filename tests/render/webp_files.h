#pragma once
#include <gtest/gtest.h>
#include <webp/demux.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "core/read_file.h"
#include "render/image.h"

namespace morphgrid {

struct WebpFrame {
  Image image;
  int endMilliseconds;  ///< Since the animation began.
};

/// All frames of an animation that plays for ever.
inline std::vector<WebpFrame> readWebp(const std::filesystem::path& path) {
  const std::string bytes = readFile(path);
  const WebPData data{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
  const std::unique_ptr<WebPAnimDecoder, decltype(&WebPAnimDecoderDelete)> decoder(
      WebPAnimDecoderNew(&data, nullptr), &WebPAnimDecoderDelete);
  WebPAnimInfo info{};
  EXPECT_TRUE(WebPAnimDecoderGetInfo(decoder.get(), &info));
  EXPECT_EQ(info.loop_count, 0) << "it plays for ever";
  std::vector<WebpFrame> frames;
  while (WebPAnimDecoderHasMoreFrames(decoder.get())) {
    std::uint8_t* pixels = nullptr;
    int end = 0;
    EXPECT_TRUE(WebPAnimDecoderGetNext(decoder.get(), &pixels, &end));
    const int width = static_cast<int>(info.canvas_width);
    const int height = static_cast<int>(info.canvas_height);
    frames.push_back({{width, height, {pixels, pixels + 4 * std::size_t(width) * height}}, end});
  }
  EXPECT_EQ(frames.size(), info.frame_count);
  return frames;
}

}  // namespace morphgrid
