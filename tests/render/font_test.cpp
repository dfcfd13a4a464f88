#include "render/font.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr Color kBlack = {0, 0, 0};

Image whiteImage(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(4 * std::size_t(width) * height, 255)};
}

std::string messageOf(const std::filesystem::path& file) {
  try {
    const Font font(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Utf8, IsDecoded) {
  EXPECT_THAT(decodeUtf8("a°−𝄞"), ElementsAre('a', 0xB0, 0x2212, 0x1D11E));
  EXPECT_THAT(decodeUtf8(""), ElementsAre());
}

TEST(Utf8, WhatIsNotUtf8IsReplaced) {
  EXPECT_THAT(decodeUtf8("a\xFFz"), ElementsAre('a', 0xFFFD, 'z'));
  EXPECT_THAT(decodeUtf8("\xC2z"), ElementsAre(0xFFFD, 'z'));
  EXPECT_THAT(decodeUtf8("z\xE2\x88"), ElementsAre('z', 0xFFFD));
}

TEST(Font, WidthGrowsWithTextAndSize) {
  const Font font = Font::findSans();
  EXPECT_EQ(font.widthOf("", 20), 0);
  EXPECT_LT(font.widthOf("strain", 20), font.widthOf("strains", 20));
  EXPECT_NEAR(font.widthOf("strain", 40), 2 * font.widthOf("strain", 20), 1e-3);
}

TEST(Font, WritesWithinItsWidthAndAboveItsBaseline) {
  const Font font = Font::findSans();
  const int width = static_cast<int>(font.widthOf("HEX", 20)) + 1;
  Image image = whiteImage(2 * width, 60);
  font.write(image, "HEX", 20, width / 2.0, 40, kBlack);
  int dark = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (image.rgba[4 * (std::size_t(y) * image.width + x)] < 128) {
        ++dark;
        EXPECT_TRUE(y < 41 && y >= 20 && x >= width / 2 - 1 && x <= width / 2 + width)
            << x << ", " << y;
      }
    }
  }
  EXPECT_GT(dark, 50);
}

TEST(Font, LeavesOutWhatLiesOutside) {
  const Font font = Font::findSans();
  for (const double x : {-500.0, -20.0, 0.0, 25.0, 500.0}) {
    for (const double y : {-30.0, 3.0, 15.0, 25.0, 90.0}) {
      Image image = whiteImage(30, 20);
      font.write(image, "Wide text", 30, x, y, kBlack);  // The sanitizers watch.
      EXPECT_EQ(image.rgba.size(), 4U * 30 * 20);
    }
  }
}

TEST(Font, FileThatIsMissingOrNoFontIsNamed) {
  const TemporaryFolder folder;
  EXPECT_THAT(messageOf(folder / "none.ttf"), HasSubstr("none.ttf"));
  EXPECT_THAT(messageOf(folder.write("empty.ttf", "")), HasSubstr("not a TrueType font"));
  EXPECT_THAT(messageOf(folder.write("text.ttf", "this is some text, not a font at all")),
              HasSubstr("text.ttf: this is not a TrueType font"));
}

}  // namespace
}  // namespace morphgrid
