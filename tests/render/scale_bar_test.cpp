#include "render/scale_bar.h"

#include <gtest/gtest.h>

namespace morphgrid {
namespace {

TEST(ScaleBar, IsOfARoundLength) {
  EXPECT_DOUBLE_EQ(roundLength(1), 1);
  EXPECT_DOUBLE_EQ(roundLength(1.9), 1);
  EXPECT_DOUBLE_EQ(roundLength(4.9), 2);
  EXPECT_DOUBLE_EQ(roundLength(73), 50);
  EXPECT_DOUBLE_EQ(roundLength(0.0023), 0.002);
}

TEST(ScaleBar, IsMostOfWhatThereIsRoomFor) {
  for (double largest = 0.01; largest < 100; largest *= 1.1) {
    EXPECT_LE(roundLength(largest), largest * (1 + 1e-12));
    EXPECT_GT(roundLength(largest), 0.4 * largest);
  }
}

TEST(ScaleBar, IsAsLongInThePictureAsItSays) {
  constexpr double kHeight = 600;
  Eigen::Matrix3Xd square(3, 4);
  square << 0, 10, 10, 0, 0, 0, 8, 8, 0, 0, 0, 0;
  const Camera camera = frameAll(square, {0, 0, -1}, {0, 1, 0}, 4.0 / 3);
  const auto bar = scaleBarAt(camera, {5, 4, 0}, kHeight, 200, {12.5, "mm"});
  ASSERT_TRUE(bar);
  EXPECT_LE(bar->pixels, 200);
  const double length = std::stod(bar->text);
  EXPECT_EQ(bar->text, LengthUnit({12.5, "mm"}).text(length));
  // Two points that far apart, seen by the camera's own matrix.
  const auto heightOf = [&](double y) {
    const glm::dvec4 clip = camera.clipFromWorld() * glm::dvec4(5, y, 0, 1);
    return clip.y / clip.w * kHeight / 2;
  };
  EXPECT_NEAR(std::abs(heightOf(4 + length / 12.5) - heightOf(4)), bar->pixels, 1e-6);
}

TEST(ScaleBar, NamesOneUnitAndSeveral) {
  const LengthUnit units{.name = "units", .nameOfOne = "unit"};
  EXPECT_EQ(units.text(1), "1 unit");
  EXPECT_EQ(units.text(0.5), "0.5 units");
  EXPECT_EQ((LengthUnit{}).text(20), "20");
}

}  // namespace
}  // namespace morphgrid
