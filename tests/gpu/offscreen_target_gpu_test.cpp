#include "gpu/offscreen_target.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "gpu/vulkan_device.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

class OffscreenTargets : public DeviceTest, public testing::WithParamInterface<std::uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Samples, OffscreenTargets, testing::Values(1, 4));

TEST_P(OffscreenTargets, WithNothingDrawnAreWhite) {
  OffscreenTarget target(device_, 37, 21, GetParam());
  for (int picture = 0; picture < 2; ++picture) {
    const auto bytes = target.render([](const auto&) {});
    ASSERT_EQ(bytes.size(), 4U * 37 * 21);
    EXPECT_THAT(bytes, testing::Each(255));
  }
}

TEST_P(OffscreenTargets, OfTooManyPixelsAreRefused) {
  const std::uint32_t width = 2 * device_.handles().properties.limits.maxImageDimension2D + 7;
  try {
    const OffscreenTarget target(device_, width, 10, GetParam());
    FAIL() << "no error";
  } catch (const DeviceError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(std::to_string(width) + " x 10"));
  }
}

TEST_F(DeviceTest, OffscreenTargetTakesTheSamplesThatTheDeviceHas) {
  const vk::PhysicalDeviceLimits& limits = device_.handles().properties.limits;
  const auto counts = limits.framebufferColorSampleCounts & limits.framebufferDepthSampleCounts;
  const bool four = static_cast<bool>(counts & vk::SampleCountFlagBits::e4);
  EXPECT_EQ(OffscreenTarget(device_, 8, 8, 4).pass().samples(), four ? 4U : 1U);
  EXPECT_EQ(OffscreenTarget(device_, 8, 8, 1).pass().samples(), 1U);
}

}  // namespace
}  // namespace morphgrid
