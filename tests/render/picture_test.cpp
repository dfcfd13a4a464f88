#include "render/picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "shared/share_color.h"
#include "shared/strain_color.h"
#include "tests/render/pixels.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

Image sceneOf(const PictureOptions& options, std::uint8_t value = 255) {
  const SceneSize size = sceneSize(options);
  return {size.width, size.height,
          std::vector<std::uint8_t>(4 * std::size_t(size.width) * size.height, value)};
}

PictureOptions options(std::string caption, bool legend, int width = 800, int height = 600) {
  return {width, height, std::move(caption), legend ? std::optional(strainLegend()) : std::nullopt};
}

Image pictureOf(const PictureOptions& options) { return composePicture(sceneOf(options), options); }

TEST(Picture, HasTheSizeAskedForAndKeepsTheScene) {
  for (const auto& [width, height] : {std::pair(64, 64), {333, 217}, {1280, 960}, {200, 1000}}) {
    const PictureOptions wanted = options("caption", true, width, height);
    const Image scene = sceneOf(wanted, 77);
    const Image picture = composePicture(scene, wanted);
    EXPECT_EQ(picture.width, width);
    EXPECT_EQ(picture.height, height);
    ASSERT_EQ(picture.rgba.size(), 4 * std::size_t(width) * height);
    EXPECT_TRUE(std::equal(scene.rgba.begin(), scene.rgba.end(), picture.rgba.begin()));
    EXPECT_GT(sceneSize(wanted).height, height / 3);
  }
}

TEST(Picture, WithoutCaptionAndLegendIsWhite) {
  EXPECT_TRUE(coloredPixels(pictureOf(options("", false))).empty());
}

TEST(Picture, CaptionStandsBelowTheSceneOnTheLeft) {
  const PictureOptions wanted = options("strip, 30 × 4 nodes", false);
  const PixelBox box = coloredBox(pictureOf(wanted));
  EXPECT_GE(box.top, sceneSize(wanted).height);
  EXPECT_LT(box.bottom, wanted.height);
  EXPECT_GT(box.left, 0);
  EXPECT_LT(box.right, wanted.width / 2);
}

TEST(Picture, LegendStandsBelowTheSceneOnTheRight) {
  const PictureOptions wanted = options("", true);
  const PixelBox box = coloredBox(pictureOf(wanted));
  EXPECT_GE(box.top, sceneSize(wanted).height);
  EXPECT_LT(box.bottom, wanted.height - 1) << "the labels are not cut off";
  EXPECT_GT(box.left, wanted.width / 3);
  EXPECT_LT(box.right, wanted.width - 1) << "the labels are not cut off";
}

/// The longest run of pixels of a row that are not white.
std::vector<Pixel> longestRun(const Image& image, int row) {
  std::vector<Pixel> longest, run;
  for (int x = 0; x < image.width; ++x) {
    const Pixel pixel = pixelAt(image, x, row);
    run = isWhite(pixel) ? std::vector<Pixel>() : run;
    if (!isWhite(pixel)) {
      run.push_back(pixel);
      longest = run.size() > longest.size() ? run : longest;
    }
  }
  return longest;
}

void expectColor(const Pixel& pixel, const vec3& color) {
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(pixel[channel], 255 * color[channel], 4);
  }
}

TEST(Picture, BarShowsTheColorsOfStrains) {
  const Image picture = pictureOf(options("", true));
  const std::vector<Pixel> bar = longestRun(picture, coloredBox(picture).top + 5);
  ASSERT_GT(bar.size(), 100U);
  expectColor(bar.front(), strainColor(-0.2F));
  expectColor(bar[bar.size() / 4], strainColor(-0.1F));
  expectColor(bar[bar.size() / 2], strainColor(0));
  expectColor(bar[3 * bar.size() / 4], strainColor(0.1F));
  expectColor(bar.back(), strainColor(0.2F));
}

std::vector<Pixel> barOf(const Legend& legend) {
  PictureOptions wanted = options("", false);
  wanted.legend = legend;
  const Image picture = pictureOf(wanted);
  return longestRun(picture, coloredBox(picture).top + 5);
}

TEST(Picture, BarOfShrinkShowsWhatIsBeyondItsEnds) {
  const std::vector<Pixel> bar = barOf(shrinkLegend());
  ASSERT_GT(bar.size(), 100U);
  expectColor(bar[bar.size() / 10], shareColor(-1));
  expectColor(bar[bar.size() / 2], shareColor(0.5));
  expectColor(bar[bar.size() * 9 / 10], shareColor(2));
}

TEST(Picture, BarOfDistancesRunsFromNoneToTheLargest) {
  const std::vector<Pixel> bar = barOf(distanceLegend(0.75, 4.5));
  expectColor(bar.front(), shareColor(0));
  expectColor(bar.back(), shareColor(1));
  const Legend legend = distanceLegend(0.75, 4.5);
  EXPECT_EQ(legend.marks.back().text, "4.5 %");
  EXPECT_EQ(legend.marks.back().secondLine, "0.75");
}

TEST(Picture, SecondLinesOfMarksAreNotCutOff) {
  for (const auto& [width, height] : {std::pair(64, 64), {800, 600}, {200, 1000}}) {
    PictureOptions wanted = options("", false, width, height);
    wanted.legend = distanceLegend(0.25, 1.25);
    EXPECT_LT(coloredBox(pictureOf(wanted)).bottom, height - 1);
  }
}

TEST(Picture, LongCaptionIsCutBeforeTheLegend) {
  const std::string caption(500, 'm');
  const Image both = pictureOf(options(caption, true));
  const Image captionOnly = pictureOf(options(caption.substr(0, 10), true));
  const PixelBox legend = coloredBox(pictureOf(options("", true)));
  for (int y = legend.top; y <= legend.bottom; ++y) {
    for (int x = legend.left - 5; x < both.width; ++x) {
      ASSERT_EQ(pixelAt(both, x, y), pixelAt(captionOnly, x, y)) << x << ", " << y;
    }
  }
  EXPECT_GT(coloredBox(pictureOf(options(caption, false))).right, 700);
}

TEST(Picture, LongCaptionGoesOnOnASecondLine) {
  const auto boxOf = [](int words) {
    std::string caption;
    for (int n = 0; n < words; ++n) {
      caption += "word ";
    }
    return coloredBox(pictureOf(options(caption, false)));
  };
  const PixelBox once = boxOf(10), twice = boxOf(35), often = boxOf(100);
  EXPECT_EQ(twice.top, once.top);
  EXPECT_GT(twice.bottom, once.bottom + 8);
  EXPECT_EQ(often.bottom, twice.bottom) << "there is no third line";
  EXPECT_LT(often.bottom, 599);
  EXPECT_LT(often.right, 799);
}

TEST(Picture, CutCaptionStaysUtf8) {
  EXPECT_NO_THROW(pictureOf(options("°°°°°°°°°°°°°°°°°°°°°°°°°°°°°°°°°°°", true, 64, 64)));
}

TEST(Png, ReadBackIsTheSame) {
  const TemporaryFolder folder;
  Image image{33, 17, std::vector<std::uint8_t>(4 * 33 * 17)};
  for (std::size_t n = 0; n < image.rgba.size(); ++n) {
    image.rgba[n] = static_cast<std::uint8_t>(n % 4 == 3 ? 255 : n * n % 251);
  }
  writePng(folder / "image.png", image);
  const Image read = readPng(folder / "image.png");
  EXPECT_EQ(read.width, 33);
  EXPECT_EQ(read.height, 17);
  EXPECT_EQ(read.rgba, image.rgba);
  EXPECT_EQ(folder.fileCount(), 1);
}

TEST(Png, MissingFolderIsNamed) {
  const TemporaryFolder folder;
  try {
    writePng(folder / "missing/image.png", Image{1, 1, {1, 2, 3, 255}});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("missing/image.png: cannot be written"));
  }
}

}  // namespace
}  // namespace morphgrid
