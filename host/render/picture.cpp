#include "render/picture.h"

#include <fmt/format.h>
#include <stb/stb_image_write.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string_view>

#include "core/atomic_file.h"
#include "core/output_error.h"
#include "render/font.h"

namespace morphgrid {
namespace {

constexpr Color kInk = {45, 50, 60};
constexpr std::string_view kEllipsis = "…";
constexpr double kSmallestLetters = 9;  // Pixels.
constexpr double kLineHeight = 1.05;    // In letters.
constexpr double kCaptionLineHeight = 1.2;

/// Where things stand below the scene, in pixels; all follows from the size of the letters.
struct Footer {
  double letters;
  int height;
  int margin;    ///< Left and right.
  int baseline;  ///< Baseline of the caption and of the legend's title.
  int barLeft, barTop, barWidth, barHeight;
};

Footer layOutFooter(const PictureOptions& options) {
  const double side = std::min(0.75 * options.width, 1.0 * options.height);
  const double letters = std::max(kSmallestLetters, std::round(side / options.lettersPerSide));
  const auto inLetters = [&](double count) {
    return static_cast<int>(std::lround(count * letters));
  };
  Footer footer{};
  footer.letters = letters;
  footer.height = inLetters(4.2);
  footer.margin = inLetters(1.2);
  footer.barWidth = std::min(inLetters(14), options.width / 3);
  footer.barHeight = inLetters(0.75);
  // The label at its end is centred there, and needs room.
  footer.barLeft = options.width - 2 * footer.margin - footer.barWidth;
  footer.barTop = options.height - footer.height + inLetters(0.35);
  footer.baseline = footer.barTop + inLetters(0.7);
  return footer;
}

void fillColumn(Image& image, int x, int top, int bottom, const Color& color) {
  for (int y = top; y < bottom; ++y) {
    std::copy(color.begin(), color.end(),
              &image.rgba[4 * (static_cast<std::size_t>(y) * image.width + x)]);
  }
}

Color bytesOf(const glm::vec3& color) {
  const auto byte = [](float value) { return static_cast<std::uint8_t>(std::lround(255 * value)); };
  return {byte(color.r), byte(color.g), byte(color.b)};
}

void drawBar(Image& image, const Footer& footer, const Legend& legend) {
  for (int x = 0; x < footer.barWidth; ++x) {
    fillColumn(image, footer.barLeft + x, footer.barTop, footer.barTop + footer.barHeight,
               bytesOf(legend.colorAt((x + 0.5) / footer.barWidth)));
  }
}

void drawMark(Image& image, const Footer& footer, const Font& font, const LegendMark& mark) {
  const double x = footer.barLeft + mark.place * (footer.barWidth - 1);
  const int bottom = footer.barTop + footer.barHeight;
  const int height = std::max(2, static_cast<int>(footer.letters / 5));
  fillColumn(image, static_cast<int>(x), bottom, bottom + height, kInk);
  double baseline = bottom + 1.1 * footer.letters;
  for (const std::string_view text : {mark.text, mark.secondLine}) {
    font.write(image, text, footer.letters, x - font.widthOf(text, footer.letters) / 2, baseline,
               kInk);
    baseline += kLineHeight * footer.letters;
  }
}

/// Where the legend begins.
double legendLeft(const Footer& footer, const Font& font, const Legend& legend) {
  return footer.barLeft - footer.letters - font.widthOf(legend.title, footer.letters);
}

void drawLegend(Image& image, const Footer& footer, const Font& font, const Legend& legend) {
  drawBar(image, footer, legend);
  for (const LegendMark& mark : legend.marks) {
    drawMark(image, footer, font, mark);
  }
  font.write(image, legend.title, footer.letters, legendLeft(footer, font, legend), footer.baseline,
             kInk);
}

/// The longest beginning of the text that fits, with an ellipsis where it was cut.
std::string fitted(std::string text, const Font& font, double letters, double width) {
  if (font.widthOf(text, letters) <= width) {
    return text;
  }
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
  while (!text.empty() && font.widthOf(text + std::string(kEllipsis), letters) > width) {
    while (text.size() > 1 && continues(text.back())) {
      text.pop_back();
    }
    text.pop_back();
  }
  return text + std::string(kEllipsis);
}

/// Where the second line begins: after the last word that fits on the first; 0 where none fits.
std::size_t secondLine(const std::string& text, const Font& font, double letters, double width) {
  std::size_t begin = 0;
  for (std::size_t space = text.find(' ');
       space != std::string::npos && font.widthOf(text.substr(0, space), letters) <= width;
       space = text.find(' ', space + 1)) {
    begin = space + 1;
  }
  return begin;
}

std::vector<std::string> linesOf(const std::string& caption, const Font& font, double letters,
                                 double width) {
  const std::size_t second = secondLine(caption, font, letters, width);
  if (second == 0 || font.widthOf(caption, letters) <= width) {
    return {fitted(caption, font, letters, width)};
  }
  return {caption.substr(0, second - 1), fitted(caption.substr(second), font, letters, width)};
}

void drawCaption(Image& image, const Footer& footer, const Font& font,
                 const PictureOptions& options) {
  const double right = options.legend
                           ? legendLeft(footer, font, *options.legend) - 2 * footer.letters
                           : options.width - footer.margin;
  double baseline = footer.baseline;
  for (const std::string& line :
       linesOf(options.caption, font, footer.letters, right - footer.margin)) {
    font.write(image, line, footer.letters, footer.margin, baseline, kInk);
    baseline += kCaptionLineHeight * footer.letters;
  }
}

void fillBlock(Image& image, int left, int top, int width, int height) {
  for (int x = std::max(left, 0); x < std::min(left + width, image.width); ++x) {
    fillColumn(image, x, std::max(top, 0), std::min(top + height, image.height), kInk);
  }
}

void drawScaleBar(Image& image, const Footer& footer, const Font& font, const ScaleBar& bar) {
  const int thick = std::max(2, static_cast<int>(footer.letters / 7));
  const int tick = static_cast<int>(footer.letters / 3);
  const int width = static_cast<int>(std::lround(bar.pixels));
  const int left = footer.margin;
  const int y = image.height - footer.height - footer.margin;
  fillBlock(image, left, y, width, thick);
  for (const int x : {left, left + width - thick}) {
    fillBlock(image, x, y - tick, thick, 2 * tick + thick);
  }
  const double middle = left + (width - font.widthOf(bar.text, footer.letters)) / 2;
  font.write(image, bar.text, footer.letters, std::max(middle, 1.0 * footer.margin),
             y - tick - 0.35 * footer.letters, kInk);
}

/// A channel that is the same everywhere still takes its share of a file.
std::vector<std::uint8_t> withoutAlpha(const Image& image) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(image.rgba.size() / 4 * 3);
  for (std::size_t n = 0; n < image.rgba.size(); n += 4) {
    rgb.insert(rgb.end(), &image.rgba[n], &image.rgba[n] + 3);
  }
  return rgb;
}

}  // namespace

SceneSize sceneSize(const PictureOptions& options) {
  assert(options.width >= kSmallestPicture && options.height >= kSmallestPicture);
  return {options.width, options.height - layOutFooter(options).height};
}

Image composePicture(const Image& scene, const PictureOptions& options) {
  assert(scene.width == options.width && scene.height == sceneSize(options).height);
  const Footer footer = layOutFooter(options);
  Image picture{options.width, options.height, scene.rgba};
  picture.rgba.resize(4 * static_cast<std::size_t>(options.width) * options.height, 255);
  if (options.legend || options.scaleBar || !options.caption.empty()) {
    const Font font = Font::findSans();
    if (options.scaleBar) {
      drawScaleBar(picture, footer, font, *options.scaleBar);
    }
    drawCaption(picture, footer, font, options);
    if (options.legend) {
      drawLegend(picture, footer, font, *options.legend);
    }
  }
  return picture;
}

void writePng(const std::filesystem::path& path, const Image& image) {
  constexpr int kChannels = 3;
  const std::vector<std::uint8_t> rgb = withoutAlpha(image);
  std::string bytes;
  const auto append = [](void* target, void* data, int size) {
    static_cast<std::string*>(target)->append(static_cast<const char*>(data),
                                              static_cast<std::size_t>(size));
  };
  if (stbi_write_png_to_func(append, &bytes, image.width, image.height, kChannels, rgb.data(),
                             kChannels * image.width) == 0) {
    throw OutputError(fmt::format("{}: the picture cannot be packed", path.string()));
  }
  writeFileAtomically(path, bytes);
}

}  // namespace morphgrid
