#pragma once
#include <filesystem>
#include <memory>

#include "render/image.h"

struct WebPAnimEncoder;

namespace morphgrid {

/// An animated WebP under construction: frame after frame, packed at once. It plays over and over.
class WebpAnimation {
 public:
  static constexpr int kLargestSide = 16383;  ///< Pixels.

  /// The size of all frames, in pixels, 1 to kLargestSide.
  WebpAnimation(int width, int height);

  /// Opaque. Throws InputError when it cannot be packed.
  void add(const Image& frame, int milliseconds);

  /// After the last frame. Throws InputError naming the path when the file cannot be written; one
  /// that was there is then kept.
  void write(const std::filesystem::path& path);

 private:
  struct Deleter {
    void operator()(WebPAnimEncoder* encoder) const;
  };

  int width_;
  int height_;
  int milliseconds_ = 0;  ///< Duration of all frames so far.
  std::unique_ptr<WebPAnimEncoder, Deleter> encoder_;
};

}  // namespace morphgrid
