#include "benchmark/fidelity_picture.h"

#include <gtest/gtest.h>

#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

class FidelityPictureTest : public DeviceTest {};

/// A flat square of 40 x 40 cells of length 1.
FidelityRun squareRun(double layerSpacing) {
  FidelityRun run;
  run.record.grid = {{41, 41, 3}, 1, layerSpacing, 0};
  run.frame.asDesigned.max = 1;
  run.targets.resize(3, 41 * 41);
  for (int j = 0; j < 41; ++j) {
    for (int i = 0; i < 41; ++i) {
      run.targets.col(j * 41 + i) = Eigen::Vector3d(i, j, 0);
    }
  }
  run.middle = run.targets;
  run.view = kTopView;
  return run;
}

// It shows the middle layer. In units of so small a layer spacing its positions would leave the
// range of the device's fixed point.
TEST_F(FidelityPictureTest, DoesNotDependOnTheLayerSpacing) {
  const auto drawn = [&](double layerSpacing) {
    const FidelityRun run = squareRun(layerSpacing);
    return drawFidelity(device_, {"square", false, run, run, run}).rgba;
  };
  EXPECT_EQ(drawn(1e-6), drawn(0.3));
}

}  // namespace
}  // namespace morphgrid
