// Springs that stand for bars against the frame of bars, on the paper's designs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "design/material.h"
#include "grid/bar_section.h"
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
constexpr double kPoisson = 0.45;  // Of soft polymers.

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

  Equilibrium solve(const StrutGrid& grid) const {
    const Equilibrium found = MultigridSolver(device_, grid).solve({});
    EXPECT_TRUE(found.converged);
    return found;
  }
  /// Grids have several equilibria: the one beside those positions.
  Equilibrium solveFrom(const Eigen::Matrix3Xd& positions, const StrutGrid& grid) const {
    MultigridSolver solver(device_, grid);
    solver.moveTo(positions, {});
    const Equilibrium found = solver.solve({.startsNear = true});
    EXPECT_TRUE(found.converged);
    return found;
  }
};

/// Bars that reach to their joints' centres and shear, as the weights assume.
StrutGrid asFrame(StrutGrid grid, double width) {
  const BarSection section = rectangularSection(
      {.width = width, .height = width, .poisson = kPoisson}, 1 / (width * width));
  grid.bars = Bars{section, section, grid.positions};
  return grid;
}

StrutGrid asSprings(StrutGrid grid, double width) {
  applyMaterial(grid, {.model = Model::bars, .barWidth = width});
  return grid;
}

TEST_P(SpringsForBars, ComeCloseToTheFrame) {
  const StrutGrid grid = designed();
  double sum = 0;
  forEachLateralStrut(grid.shape, [&](const Strut& strut) { sum += valueAt(grid.rest, strut); });
  const double length = sum / grid.shape.lateralStrutCount();
  for (const double thickness : GetParam().thicknesses) {
    const Equilibrium frame = solve(asFrame(grid, thickness * length));
    const Equilibrium springs = solveFrom(frame.positions, asSprings(grid, thickness * length));
    const double apart =
        computeShapeError(grid.shape, springs.positions, middleLayer(grid.shape, frame.positions))
            .rmsPercent;
    EXPECT_LT(apart, kAlike) << thickness;
    RecordProperty(fmt::format("rms_percent_at_{:g}", thickness), fmt::format("{:.3g}", apart));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SpringsForBars,
                         testing::Values(Case{"egg_chair.toml", {0.1, 0.2, 0.35}},
                                         Case{"patch.toml", {0.2, 0.5}},
                                         Case{"iris_petal.toml", {0.35}}));

}  // namespace
}  // namespace morphgrid
