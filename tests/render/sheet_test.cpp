#include "render/sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/render/pixels.h"

namespace morphgrid {
namespace {

const SheetOptions kSheet{.title = "A sheet", .columns = 3, .panelWidth = 320, .panelHeight = 240};

Panel panelOf(const SheetOptions& options, std::uint8_t value, std::string caption = "") {
  const SceneSize size = sceneSize(panelPicture(options));
  return {{size.width, size.height,
           std::vector<std::uint8_t>(4 * std::size_t(size.width) * size.height, value)},
          std::move(caption),
          {}};
}

/// The part of an image from (left, top) on.
Image cropped(const Image& image, int left, int top, int width, int height) {
  Image part{width, height, {}};
  for (int y = top; y < top + height; ++y) {
    const auto row = image.rgba.begin() + 4 * (std::ptrdiff_t(y) * image.width + left);
    part.rgba.insert(part.rgba.end(), row, row + 4 * std::ptrdiff_t(width));
  }
  return part;
}

TEST(Sheet, PanelsStandInRowsUnderTheTitle) {
  std::vector<Panel> panels;
  for (const int value : {10, 20, 30, 40, 50}) {
    panels.push_back(panelOf(kSheet, static_cast<std::uint8_t>(value)));
  }
  const Image sheet = composeSheet(panels, kSheet);
  EXPECT_EQ(sheet.width, 3 * 320);
  const int title = sheet.height - 2 * 240;
  ASSERT_GT(title, 10);
  ASSERT_LT(title, 40);
  EXPECT_FALSE(coloredPixels(cropped(sheet, 0, 0, sheet.width, title)).empty());
  EXPECT_EQ(pixelAt(sheet, 0, title), (Pixel{10, 10, 10}));
  EXPECT_EQ(pixelAt(sheet, 320, title), (Pixel{20, 20, 20}));
  EXPECT_EQ(pixelAt(sheet, 959, title), (Pixel{30, 30, 30}));
  EXPECT_EQ(pixelAt(sheet, 319, title + 240), (Pixel{40, 40, 40}));
  EXPECT_EQ(pixelAt(sheet, 639, title + 240), (Pixel{50, 50, 50}));
  EXPECT_TRUE(coloredPixels(cropped(sheet, 640, title + 240, 320, 240)).empty());
}

TEST(Sheet, OfFewPanelsIsNarrow) {
  const Image sheet = composeSheet({panelOf(kSheet, 10), panelOf(kSheet, 20)}, kSheet);
  EXPECT_EQ(sheet.width, 2 * 320);
  EXPECT_LT(sheet.height, 2 * 240);
}

TEST(Sheet, PanelsArePicturesWithNumberedCaptions) {
  std::vector<Panel> panels{panelOf(kSheet, 10, "first"), panelOf(kSheet, 20, "second")};
  panels[1].legend = strainLegend();
  const Image sheet = composeSheet(panels, kSheet);
  for (int n = 0; n < 2; ++n) {
    PictureOptions picture = panelPicture(kSheet);
    picture.caption = n == 0 ? "(a) first" : "(b) second";
    picture.legend = panels[n].legend;
    EXPECT_EQ(cropped(sheet, 320 * n, sheet.height - 240, 320, 240).rgba,
              composePicture(panels[n].scene, picture).rgba)
        << n;
  }
}

TEST(Sheet, TooManyPixelsAreRefused) {
  SheetOptions large = kSheet;
  large.panelWidth = large.panelHeight = 8192;
  EXPECT_NO_THROW(sheetSize(large, 6));
  try {
    sheetSize(large, 9);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("9 panels of 8192 x 8192"));
  }
}

TEST(TextPanel, HoldsAllOfItsLines) {
  const SceneSize size = sceneSize(panelPicture(kSheet));
  for (const auto& [lines, columns] : {std::pair(1, 1), {60, 3}, {2, 200}, {40, 90}}) {
    std::string text;
    for (int line = 0; line < lines; ++line) {
      text += std::string(columns, 'm') + '\n';
    }
    const Image image = drawText(text, kSheet);
    EXPECT_EQ(image.width, size.width);
    EXPECT_EQ(image.height, size.height);
    const PixelBox box = coloredBox(image);
    EXPECT_GE(box.left, 0);
    EXPECT_LT(box.right, size.width - 1) << lines << " x " << columns;
    EXPECT_LT(box.bottom, size.height - 1) << lines << " x " << columns;
  }
}

TEST(TextPanel, LettersAreAsLargeAsTheyCanBeButNotLarger) {
  const PixelBox few = coloredBox(drawText("mm\n", kSheet));
  const PixelBox fewer = coloredBox(drawText("m\n", kSheet));
  const PixelBox wide = coloredBox(drawText(std::string(100, 'm'), kSheet));
  EXPECT_EQ(few.bottom - few.top, fewer.bottom - fewer.top);
  EXPECT_GT(wide.right, sceneSize(panelPicture(kSheet)).width * 9 / 10);
}

}  // namespace
}  // namespace morphgrid
