#include <gtest/gtest.h>

#include "benchmark/ladder.h"
#include "solve/multigrid_solver.h"
#include "tests/solve/frame_oracle.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

/// docs/validation.md shows what these bound.
class FrameEvidence : public DeviceTest {
 protected:
  Eigen::Matrix3Xd positionsOf(const StrutGrid& frame) {
    const Equilibrium result = MultigridSolver(device_, frame).solve({});
    EXPECT_TRUE(result.converged) << toString(result.reason);
    return result.positions;
  }

  /// Of the joints of a ladder of one row.
  Eigen::Matrix3Xd ladderOf(const StrutGrid& row, double width, double poisson,
                            const JointModel& joint) {
    const StrutGrid grid = inTwoRows(row);
    return firstRow(grid.shape, positionsOf(asFrame(grid, width, poisson, joint)));
  }
};

TEST_F(FrameEvidence, LaddersBendAsInTheirClosedForm) {
  const Ladder ladder{12, 0, 0.1, 0.5};
  for (const JointModel& joint : {kPointJoint, kSceneJoint}) {
    const double closed = closedFormTurn(ladder, 0.2, joint);
    const LadderTurns turns = turnsOf(ladderOf(ladderGrid(ladder), 0.2, 0.45, joint));
    EXPECT_NEAR(turns.inner, closed, 3e-3 * closed);
  }
}

struct SolidBound {
  const char* name;
  double percent;  ///< RMS distance to the solid over how far that moves from flat.
};

void PrintTo(const SolidBound& bound, std::ostream* stream) { *stream << bound.name; }

class FrameBesideSolids : public FrameEvidence, public testing::WithParamInterface<SolidBound> {};

TEST_P(FrameBesideSolids, EndsWhereTheyDo) {
  const FrameReference solid = loadSolveReference(GetParam().name);
  const FrameReference::Answer& answer = solid.answers.back();
  const double width = answer.thickness * solid.meanLateralRest();
  const Eigen::Matrix3Xd positions =
      solid.grid.shape.verticesV == 1
          ? ladderOf(solid.grid, width, solid.poisson, kSceneJoint)
          : positionsOf(asFrame(solid.grid, width, solid.poisson, kSceneJoint));
  const double deflection = alignedDistance(solid.grid.positions, answer.positions);
  EXPECT_LT(alignedDistance(positions, answer.positions), GetParam().percent / 100 * deflection);
}

INSTANTIATE_TEST_SUITE_P(Solids, FrameBesideSolids,
                         testing::Values(SolidBound{"solid_grid_linear_t0.2", 2},
                                         SolidBound{"solid_ladder_0_10_t0.2", 0.5},
                                         SolidBound{"solid_ladder_10_30_t0.1", 0.2},
                                         SolidBound{"solid_ladder_10_30_t0.2", 0.4},
                                         SolidBound{"solid_ladder_10_30_t0.35", 0.8},
                                         SolidBound{"solid_saddle_5_30_t0.1", 1.2},
                                         SolidBound{"solid_saddle_5_30_t0.2", 0.8},
                                         SolidBound{"solid_saddle_5_30_t0.35", 2},
                                         SolidBound{"solid_cap_4_24_t0.2", 1}));

}  // namespace
}  // namespace morphgrid
