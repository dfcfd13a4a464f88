#include "render/webp_animation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/render/pixels.h"
#include "tests/render/webp_files.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

constexpr int kWidth = 50;
constexpr int kHeight = 34;

/// White, with a box that has moved on in every frame.
Image frameOf(int number) {
  Image image{kWidth, kHeight, std::vector<std::uint8_t>(4 * kWidth * kHeight, 255)};
  for (int y = 8; y < 20; ++y) {
    for (int x = 0; x < 12; ++x) {
      std::uint8_t* pixel = &image.rgba[4 * (std::size_t(y) * kWidth + x + 8 * number)];
      pixel[0] = 200;
      pixel[1] = pixel[2] = 20;
    }
  }
  return image;
}

TEST(WebpAnimation, ReadsBackWithItsFramesAndTimes) {
  const TemporaryFolder folder;
  WebpAnimation animation(kWidth, kHeight);
  for (int n = 0; n < 4; ++n) {
    animation.add(frameOf(n), n == 3 ? 1500 : 40);
  }
  animation.write(folder / "morph.webp");
  EXPECT_EQ(folder.fileCount(), 1);
  const std::vector<WebpFrame> frames = readWebp(folder / "morph.webp");
  ASSERT_EQ(frames.size(), 4);
  for (int n = 0; n < 4; ++n) {
    EXPECT_EQ(frames[n].endMilliseconds, n == 3 ? 1620 : 40 * (n + 1));
    ASSERT_EQ(frames[n].image.width, kWidth);
    ASSERT_EQ(frames[n].image.height, kHeight);
    EXPECT_LT(differenceOf(frames[n].image, frameOf(n)).mean, 3) << "frame " << n;
    EXPECT_GT(differenceOf(frames[n].image, frameOf((n + 1) % 4)).mean, 10) << "frame " << n;
  }
}

TEST(WebpAnimation, MissingFolderIsNamed) {
  const TemporaryFolder folder;
  WebpAnimation animation(kWidth, kHeight);
  animation.add(frameOf(0), 40);
  try {
    animation.write(folder / "missing/morph.webp");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("missing/morph.webp: cannot be written"));
  }
}

}  // namespace
}  // namespace morphgrid
