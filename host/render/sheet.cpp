#include "render/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>

#include "core/error.h"
#include "render/font.h"

namespace morphgrid {
namespace {

constexpr Color kText = {45, 50, 60};
constexpr double kLinesPerPanel = 34;     // Lines of a caption that would fill a panel.
constexpr double kTitle = 1.6;            // Letters of the title, in those of captions.
constexpr double kTitleMargin = 0.7;      // Above, below and left of it, in letters of the title.
constexpr double kTextLineHeight = 1.25;  // In letters.

double lettersOf(const SheetOptions& options) {
  return std::min(0.75 * options.panelWidth, 1.0 * options.panelHeight) / kLinesPerPanel;
}

double titleLetters(const SheetOptions& options) { return kTitle * lettersOf(options); }

int titleHeight(const SheetOptions& options) {
  return static_cast<int>(std::lround((1 + 2 * kTitleMargin) * titleLetters(options)));
}

int columnCount(const SheetOptions& options, int panelCount) {
  return std::min(options.columns, panelCount);
}

Image whiteImage(int width, int height) {
  return {width, height,
          std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width) * height, 255)};
}

void paste(Image& image, const Image& part, int left, int top) {
  const std::size_t rowBytes = 4 * static_cast<std::size_t>(part.width);
  for (int row = 0; row < part.height; ++row) {
    std::copy_n(&part.rgba[row * rowBytes], rowBytes,
                &image.rgba[4 * (static_cast<std::size_t>(top + row) * image.width + left)]);
  }
}

void writeTitle(Image& sheet, const SheetOptions& options) {
  const double letters = titleLetters(options);
  Font::findSans().write(sheet, options.title, letters, kTitleMargin * letters,
                         (kTitleMargin + 0.8) * letters, kText);
}

Image pictureOf(const Panel& panel, int number, const SheetOptions& options) {
  PictureOptions picture = panelPicture(options);
  picture.caption = fmt::format("({}) {}", static_cast<char>('a' + number), panel.caption);
  picture.legend = panel.legend;
  picture.scaleBar = panel.scaleBar;
  return composePicture(panel.scene, picture);
}

std::vector<std::string> splitLines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

}  // namespace

PictureOptions panelPicture(const SheetOptions& options) {
  return {.width = options.panelWidth,
          .height = options.panelHeight,
          .caption = {},
          .legend = {},
          .scaleBar = {},
          .lettersPerSide = kLinesPerPanel};
}

SheetSize sheetSize(const SheetOptions& options, int panelCount) {
  assert(panelCount >= 1 && panelCount <= kMostPanels && options.columns >= 1);
  const std::int64_t columns = columnCount(options, panelCount);
  const std::int64_t rows = (panelCount + columns - 1) / columns;
  const std::int64_t width = columns * options.panelWidth;
  const std::int64_t height = titleHeight(options) + rows * options.panelHeight;
  constexpr std::int64_t kMostPixels =
      std::numeric_limits<int>::max() / 5;  // stb counts bytes in int.
  if (width * height > kMostPixels) {
    throw InputError(fmt::format(
        "a sheet of {} panels of {} x {} pixels has {} pixels, it may have {}: make them smaller",
        panelCount, options.panelWidth, options.panelHeight, width * height, kMostPixels));
  }
  return {static_cast<int>(width), static_cast<int>(height)};
}

Image composeSheet(const std::vector<Panel>& panels, const SheetOptions& options) {
  const int count = static_cast<int>(panels.size());
  const SheetSize size = sheetSize(options, count);
  const int columns = columnCount(options, count);
  Image sheet = whiteImage(size.width, size.height);
  writeTitle(sheet, options);
  for (int n = 0; n < count; ++n) {
    paste(sheet, pictureOf(panels[n], n, options), n % columns * options.panelWidth,
          titleHeight(options) + n / columns * options.panelHeight);
  }
  return sheet;
}

Image drawText(const std::string& text, const SheetOptions& options) {
  const SceneSize size = sceneSize(panelPicture(options));
  const std::vector<std::string> lines = splitLines(text);
  const Font font = Font::findMono();
  double widest = 0;  // In letters.
  for (const std::string& line : lines) {
    widest = std::max(widest, font.widthOf(line, 1));
  }
  const double letters =
      std::min({titleLetters(options), size.width / (widest + 2),
                size.height / (kTextLineHeight * (static_cast<double>(lines.size()) + 1))});
  Image image = whiteImage(size.width, size.height);
  double baseline = kTextLineHeight * letters;
  for (const std::string& line : lines) {
    font.write(image, line, letters, letters, baseline, kText);
    baseline += kTextLineHeight * letters;
  }
  return image;
}

}  // namespace morphgrid
