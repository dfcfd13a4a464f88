#include "solve/frame_solver.h"

#include <gtest/gtest.h>

#include "energy/grid_energy.h"
#include "solve/multigrid_solver.h"
#include "tests/solve/frame_grids.h"
#include "tests/solve/frame_oracle.h"
#include "tests/solve/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

struct Case {
  const char* name;
  double thickness;
  long mostIterations;
};

void PrintTo(const Case& parameter, std::ostream* stream) {
  *stream << parameter.name << " " << parameter.thickness;
}

class FrameOracles : public DeviceTest, public testing::WithParamInterface<Case> {
 protected:
  /// The mirror twin of a grid that is as symmetric as the egg chair, and its answer.
  Eigen::Matrix3Xd twin(const Eigen::Matrix3Xd& positions) const {
    Eigen::Matrix3Xd mirrored(3, positions.cols());
    const GridShape& shape = oracle_.grid.shape;
    forEachVertex(shape, [&](const GridPlace& place) {
      mirrored.col(shape.index(place)) =
          positions.col(shape.index(shape.verticesU - 1 - place.i, place.j, place.layer));
    });
    mirrored.row(0) *= -1;
    return mirrored;
  }

  FrameOracle oracle_ = loadFrameOracle(GetParam().name, GetParam().thickness);
};

TEST_P(FrameOracles, AreReachedOnTheDevice) {
  MultigridSolver solver(device_, oracle_.grid);
  const Equilibrium result = solver.solve({});
  EXPECT_TRUE(result.converged) << toString(result.reason);
  EXPECT_LT(result.iterations, GetParam().mostIterations);
  EXPECT_NEAR(result.energy, oracle_.energy, 1e-5 * oracle_.energy);
  Mismatch mismatch = mismatchOf(result.positions, oracle_.positions);
  if (GetParam().thickness == 0.2) {
    const Mismatch ofTwin = mismatchOf(result.positions, twin(oracle_.positions));
    mismatch = ofTwin.rms < mismatch.rms ? ofTwin : mismatch;
  }
  EXPECT_LT(mismatch.rms, 0.02);
  EXPECT_LT(mismatch.largest, 0.1);
}

/// The buckled one from a saddle, on which Newton's method ends without a push.
TEST(FrameOnTheHost, ReachesTheOracles) {
  for (const double thickness : {0.5, 0.2}) {
    const FrameOracle oracle = loadFrameOracle("egg_chair", thickness);
    const Equilibrium result = solveFrame(oracle.grid, {});
    EXPECT_TRUE(result.converged) << toString(result.reason);
    EXPECT_NEAR(result.energy, oracle.energy, 1e-5 * oracle.energy);
  }
}

INSTANTIATE_TEST_SUITE_P(Prototype, FrameOracles,
                         testing::Values(Case{"egg_chair", 0.5, 40}, Case{"egg_chair", 0.2, 80},
                                         Case{"strip", 0.1, 200}));

class FrameSolvers : public DeviceTest {};

TEST_F(FrameSolvers, AgreeWithEachOther) {
  const StrutGrid grid = welded(bentGrid({9, 7, 3}, 3), {.width = 0.2, .height = 0.15});
  SolveOptions options;
  options.energyTolerance = 0;
  options.tolerance = 1e-7;
  const Equilibrium onDevice = MultigridSolver(device_, grid).solve(options);
  const Equilibrium onHost = solveFrame(grid, options);
  EXPECT_TRUE(onHost.converged) << toString(onHost.reason);
  EXPECT_TRUE(onDevice.converged) << toString(onDevice.reason) << " " << onDevice.residual;
  EXPECT_NEAR(onDevice.energy, onHost.energy, 3e-9 * onHost.energy);
  EXPECT_LT(mismatchOf(onDevice.positions, onHost.positions).largest, 1e-3);
}

TEST_F(FrameSolvers, GoOnFromWhereTheyAre) {
  const StrutGrid grid = welded(bentGrid({9, 7, 3}, 3), {.width = 0.2, .height = 0.15});
  MultigridSolver solver(device_, grid);
  const Equilibrium first = solver.solve({});
  solver.moveTo(first.positions, first.rotations);
  const Equilibrium again = solver.solve({.startsNear = true});
  EXPECT_LE(again.iterations, 6);
  EXPECT_NEAR(again.energy, first.energy, 1e-8 * first.energy);
}

}  // namespace
}  // namespace morphgrid
