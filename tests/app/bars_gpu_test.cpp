// Springs that stand for bars against the frame of bars, on the paper's designs.
#include <gtest/gtest.h>

#include "design/material.h"
#include "inverse/shape_error.h"
#include "solve/multigrid_solver.h"
#include "state/run_state.h"
#include "tests/app/subprocess.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

/// Percent of the diagonal, RMS over the middle layer.
constexpr double kAlike = 0.7;

struct Case {
  const char* scene;
  std::vector<double> thicknesses;  ///< Of the mean rest length.
};

class SpringsForBars : public DeviceTest, public testing::WithParamInterface<Case> {
 protected:
  /// As the paper prints it, with its rest lengths.
  StrutGrid designed() const {
    const TemporaryFolder folder;
    const ProcessResult run =
        runMorphgrid({"run", sourceFolder() / "scenes" / GetParam().scene, "--out", folder / "out",
                      "--quiet", "--set", "output.pictures=false"});
    EXPECT_EQ(run.exitCode, 0) << run.output;
    return readState(folder / "out" / kStateFile).grid;
  }

  Eigen::Matrix3Xd solve(StrutGrid grid, const MaterialRequest& material) const {
    applyMaterial(grid, material);
    MultigridSolver solver(device_, grid);
    const Equilibrium found = solver.solve({});
    EXPECT_TRUE(found.converged);
    return found.positions;
  }
};

TEST_P(SpringsForBars, ComeCloseToTheFrame) {
  const StrutGrid grid = designed();
  double sum = 0;
  forEachLateralStrut(grid.shape, [&](const Strut& strut) { sum += valueAt(grid.rest, strut); });
  const double length = sum / grid.shape.lateralStrutCount();
  for (const double thickness : GetParam().thicknesses) {
    MaterialRequest material{.model = Model::frame, .barWidth = thickness * length};
    const Eigen::Matrix3Xd frame = middleLayer(grid.shape, solve(grid, material));
    material.model = Model::bars;
    const ShapeError error = computeShapeError(grid.shape, solve(grid, material), frame);
    EXPECT_LT(error.rmsPercent, kAlike) << thickness;
    RecordProperty(std::to_string(thickness), std::to_string(error.rmsPercent));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SpringsForBars,
                         testing::Values(Case{"egg_chair.toml", {0.1, 0.2, 0.35}},
                                         Case{"patch.toml", {0.2, 0.5}},
                                         Case{"iris_petal.toml", {0.35}}));

}  // namespace
}  // namespace morphgrid
