#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "benchmark/bar_network.h"
#include "benchmark/ladder.h"
#include "energy/grid_energy.h"
#include "solve/frame_solver.h"
#include "tests/solve/frame_oracle.h"

namespace morphgrid {
namespace {

TEST(RolledChain, ClosesToACircle) {
  for (const int pieces : {16, 32}) {
    const NetworkState chain = rolledChain(pieces);
    EXPECT_LT((chain.positions.col(pieces) - chain.positions.col(0)).norm(), 1e-4);
    EXPECT_GT(std::abs(chain.positions(2, pieces / 2)), 0.3) << "not a straight chain";
  }
}

TEST(RolledChain, ConvergesWithTheFourthOrder) {
  const auto gap = [](int pieces) {
    const NetworkState chain = rolledChain(pieces);
    return (chain.positions.col(pieces) - chain.positions.col(0)).norm();
  };
  EXPECT_NEAR(std::log2(gap(16) / gap(32)), 4, 0.1);
}

TEST(FrameOnTheHost, BendsLaddersAsTheirClosedForm) {
  const Ladder ladder{12, 0, 0.01, 0.5};
  for (const double thickness : {0.1, 0.2, 0.35}) {
    const StrutGrid frame = asFrame(inTwoRows(ladderGrid(ladder)), thickness, 0.45, kPointJoint);
    const double closed = closedFormTurn(ladder, thickness, kPointJoint);
    const LadderTurns turns = turnsOf(firstRow(frame.shape, solveFrame(frame, {}).positions));
    EXPECT_NEAR(turns.inner, closed, 1e-3 * closed);
  }
}

struct Subdivision {
  const char* name;
  double percent;  ///< RMS between one element a bar and two, of the diagonal.
};

/// The strip's bars bend by up to 1 rad each.
TEST(FrameOnTheHost, NeedsOneElementABar) {
  for (const Subdivision& one :
       {Subdivision{"strip", 0.5}, Subdivision{"solid_saddle_5_30_t0.2", 0.05}}) {
    const FrameReference reference = loadSolveReference(one.name);
    const double width = reference.answers.back().thickness * reference.meanLateralRest();
    const StrutGrid frame = asFrame(reference.grid, width, reference.poisson, kPointJoint);
    const Equilibrium whole = solveFrame(frame, {});
    const NetworkState halves =
        solveNetwork(halvedBars(frame), halvedState(frame, {whole.positions, whole.rotations}));
    const Mismatch mismatch =
        mismatchOf(whole.positions, halves.positions.leftCols(whole.positions.cols()));
    EXPECT_LT(mismatch.rms, one.percent) << one.name;
    EXPECT_GT(mismatch.rms, one.percent / 1000) << one.name << ": the bars have not been cut";
  }
}

/// However far it is turned.
TEST(FrameOnTheHost, CostsTheSameWhereverItLies) {
  const FrameOracle oracle = loadFrameOracle("egg_chair", 0.5);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, -2, 0.5).normalized()));
  const JointRotations rotations = turnWithBars(oracle.grid, oracle.positions);
  JointRotations turned(4, rotations.cols());
  for (Eigen::Index n = 0; n < rotations.cols(); ++n) {
    turned.col(n) = (turn * Eigen::Quaterniond(rotations.col(n))).coeffs();
  }
  const Eigen::Matrix3Xd positions =
      (turn.toRotationMatrix() * oracle.positions).colwise() + Eigen::Vector3d(3, -1, 2);
  const GridEnergy energy(oracle.grid);
  const double before = energy.evaluate(oracle.positions, rotations).energy;
  EXPECT_NEAR(energy.evaluate(positions, turned).energy, before, 1e-9 * before);
}

}  // namespace
}  // namespace morphgrid
