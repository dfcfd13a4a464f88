#include "render/font.h"

#include <fmt/format.h>
#include <stb/stb_truetype.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "core/error.h"
#include "core/read_file.h"

namespace morphgrid {
namespace {

constexpr int kReplacement = 0xFFFD;
constexpr std::size_t kHeaderBytes = 12;

/// Debian and Ubuntu, Fedora, Arch.
constexpr const char* kSansFiles[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
};
constexpr const char* kMonoFiles[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
    "/usr/share/fonts/dejavu-sans-mono-fonts/DejaVuSansMono.ttf",
    "/usr/share/fonts/TTF/DejaVuSansMono.ttf",
};

std::filesystem::path firstOf(std::span<const char* const> files) {
  for (const char* file : files) {
    if (std::filesystem::exists(file)) {
      return file;
    }
  }
  throw InputError(fmt::format(
      "{}: the font of the pictures is not installed: apt-get install fonts-dejavu-core",
      files.front()));
}

std::vector<std::uint8_t> readBytes(const std::filesystem::path& file) {
  const std::string bytes = readFile(file);
  return {bytes.begin(), bytes.end()};
}

/// How many bytes follow the first one; -1 where none can.
int continuationCount(unsigned char first) {
  if (first < 0x80) {
    return 0;
  }
  if (first >= 0xC2 && first < 0xE0) {
    return 1;
  }
  if (first >= 0xE0 && first < 0xF0) {
    return 2;
  }
  return first >= 0xF0 && first < 0xF5 ? 3 : -1;
}

/// Lays a colour over a pixel; coverage 0 .. 255.
void blend(std::uint8_t* pixel, const Color& color, int coverage) {
  for (std::size_t channel = 0; channel < color.size(); ++channel) {
    const int mixed = color[channel] * coverage + pixel[channel] * (255 - coverage);
    pixel[channel] = static_cast<std::uint8_t>((mixed + 127) / 255);
  }
}

struct Glyph {
  int left, top, width, height;
  std::vector<std::uint8_t> coverage;
};

/// The shape of a letter whose origin lies `shift` pixels right of a pixel's corner.
Glyph rasterize(const stbtt_fontinfo& info, int codepoint, float scale, float shift) {
  int left, top, right, bottom;
  stbtt_GetCodepointBitmapBoxSubpixel(&info, codepoint, scale, scale, shift, 0, &left, &top, &right,
                                      &bottom);
  Glyph glyph{left, top, right - left, bottom - top, {}};
  glyph.coverage.resize(static_cast<std::size_t>(glyph.width) * glyph.height);
  if (!glyph.coverage.empty()) {
    stbtt_MakeCodepointBitmapSubpixel(&info, glyph.coverage.data(), glyph.width, glyph.height,
                                      glyph.width, scale, scale, shift, 0, codepoint);
  }
  return glyph;
}

void stamp(Image& image, const Glyph& glyph, int x, int y, const Color& color) {
  const int firstRow = std::max(0, -(y + glyph.top));
  const int lastRow = std::min(glyph.height, image.height - (y + glyph.top));
  const int firstColumn = std::max(0, -(x + glyph.left));
  const int lastColumn = std::min(glyph.width, image.width - (x + glyph.left));
  for (int row = firstRow; row < lastRow; ++row) {
    for (int column = firstColumn; column < lastColumn; ++column) {
      const auto pixel = static_cast<std::size_t>(y + glyph.top + row) * image.width +
                         static_cast<std::size_t>(x + glyph.left + column);
      blend(&image.rgba[4 * pixel], color,
            glyph.coverage[static_cast<std::size_t>(row) * glyph.width + column]);
    }
  }
}

}  // namespace

std::vector<int> decodeUtf8(std::string_view text) {
  std::vector<int> codepoints;
  for (std::size_t n = 0; n < text.size(); ++n) {
    const auto first = static_cast<unsigned char>(text[n]);
    const int count = continuationCount(first);
    int codepoint = count <= 0 ? first : first & (0x3F >> count);
    bool valid = count >= 0;
    for (int follower = 0; valid && follower < count; ++follower) {
      valid = n + 1 < text.size() && (static_cast<unsigned char>(text[n + 1]) & 0xC0) == 0x80;
      if (valid) {
        codepoint = (codepoint << 6) | (static_cast<unsigned char>(text[++n]) & 0x3F);
      }
    }
    codepoints.push_back(valid ? codepoint : kReplacement);
  }
  return codepoints;
}

Font::Font(const std::filesystem::path& file)
    : file_(readBytes(file)), info_(std::make_unique<stbtt_fontinfo>()) {
  const bool hasHeader = file_.size() >= kHeaderBytes;
  const int offset = hasHeader ? stbtt_GetFontOffsetForIndex(file_.data(), 0) : -1;
  if (offset < 0 || stbtt_InitFont(info_.get(), file_.data(), offset) == 0) {
    throw InputError(fmt::format("{}: this is not a TrueType font", file.string()));
  }
}

Font::Font(Font&&) noexcept = default;
Font::~Font() = default;

Font Font::findSans() { return Font(sansFile()); }
Font Font::findMono() { return Font(monoFile()); }
std::filesystem::path Font::sansFile() { return firstOf(kSansFiles); }
std::filesystem::path Font::monoFile() { return firstOf(kMonoFiles); }

float Font::scaleFor(double size) const {
  return stbtt_ScaleForPixelHeight(info_.get(), static_cast<float>(size));
}

double Font::kerning(int codepoint, int next, double scale) const {
  return scale * stbtt_GetCodepointKernAdvance(info_.get(), codepoint, next);
}

double Font::widthOf(std::string_view text, double size) const {
  const double scale = scaleFor(size);
  const std::vector<int> codepoints = decodeUtf8(text);
  double width = 0;
  for (std::size_t n = 0; n < codepoints.size(); ++n) {
    int advance, bearing;
    stbtt_GetCodepointHMetrics(info_.get(), codepoints[n], &advance, &bearing);
    width += scale * advance;
    width += n + 1 < codepoints.size() ? kerning(codepoints[n], codepoints[n + 1], scale) : 0;
  }
  return width;
}

void Font::write(Image& image, std::string_view text, double size, double x, double y,
                 const Color& color) const {
  const float scale = scaleFor(size);
  const std::vector<int> codepoints = decodeUtf8(text);
  const int baseline = static_cast<int>(std::lround(y));
  for (std::size_t n = 0; n < codepoints.size(); ++n) {
    const double column = std::floor(x);
    const Glyph glyph = rasterize(*info_, codepoints[n], scale, static_cast<float>(x - column));
    stamp(image, glyph, static_cast<int>(column), baseline, color);
    int advance, bearing;
    stbtt_GetCodepointHMetrics(info_.get(), codepoints[n], &advance, &bearing);
    x += scale * advance;
    x += n + 1 < codepoints.size() ? kerning(codepoints[n], codepoints[n + 1], scale) : 0;
  }
}

}  // namespace morphgrid
