#include "solve/device_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "shared/solver_types.h"
#include "tests/solve/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

class DeviceGridTest : public DeviceTest {};

TEST_F(DeviceGridTest, PositionsComeBackAsTheyWent) {
  const StrutGrid grid = bentGrid({5, 4, 3}, 7);
  const DeviceGrid onDevice(device_, grid);
  const double step = onDevice.resolution() * grid.spacing / (1 << kExtraBits);
  EXPECT_LE((onDevice.downloadPositions() - grid.positions).cwiseAbs().maxCoeff(), step);
}

TEST_F(DeviceGridTest, PositionsBeyondTheFixedPointsRangeAreRefused) {
  StrutGrid grid = bentGrid({5, 4, 3}, 7);
  grid.spacing /= 1000;  // As if a layer spacing were taken for the cells' length.
  EXPECT_THAT([&] { DeviceGrid(device_, grid); },
              testing::ThrowsMessage<InputError>(
                  testing::HasSubstr("beyond the 128 that the device's positions reach")));
}

TEST_F(DeviceGridTest, OnlookersKeepTheScaleAndSeeTheBuffers) {
  const StrutGrid grid = bentGrid({5, 4, 3}, 7);
  StrutGrid other = grid;
  other.spacing = 2;
  other.positions.array() += 4;
  DeviceGrid onDevice(device_, grid);
  const auto onlooker = onDevice.onlooker();
  onDevice.assign(other);
  onDevice.noteNewest(false);
  EXPECT_EQ(onlooker->spacing(), 1);
  EXPECT_EQ(onDevice.spacing(), 2);
  EXPECT_NE(onlooker->origin(), onDevice.origin());
  EXPECT_EQ(onlooker->positions().handle(), onDevice.positions().handle());
  EXPECT_FALSE(onlooker->newestIsFirst());
  const double step = onDevice.resolution() * other.spacing / (1 << kExtraBits);
  EXPECT_LE((onDevice.downloadPositions() - other.positions).cwiseAbs().maxCoeff(), step);
}

}  // namespace
}  // namespace morphgrid
