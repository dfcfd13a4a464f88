#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "benchmark/bar_network.h"
#include "benchmark/ladder.h"
#include "benchmark/validation_tables.h"
#include "solve/frame_solver.h"
#include "solve/multigrid_solver.h"

namespace morphgrid {
namespace {

constexpr double kLadderPoisson = 0.45;

struct LadderCase {
  Ladder ladder;
  double thickness;
  JointModel joint = kPointJoint;
};

constexpr Ladder kSlight{12, 0, 0.01, 0.5};
constexpr Ladder kMedium{12, 0, 0.1, 0.5};
constexpr Ladder kStrong{12, 0.1, 0.3, 0.5};
constexpr std::array kLadderCases = {LadderCase{kSlight, 0.1},
                                     LadderCase{kSlight, 0.2},
                                     LadderCase{kSlight, 0.35},
                                     LadderCase{kMedium, 0.1},
                                     LadderCase{kMedium, 0.2},
                                     LadderCase{kMedium, 0.35},
                                     LadderCase{kStrong, 0.1},
                                     LadderCase{kStrong, 0.2},
                                     LadderCase{kStrong, 0.35},
                                     LadderCase{kMedium, 0.2, kSceneJoint},
                                     LadderCase{kStrong, 0.2, kSceneJoint}};

double innerTurn(const StrutGrid& grid, const Equilibrium& result) {
  return turnsOf(firstRow(grid.shape, result.positions)).inner;
}

std::string ladderRow(const Device& device, const LadderCase& one) {
  const StrutGrid springs = inTwoRows(ladderGrid(one.ladder));
  const StrutGrid frame = asFrame(springs, one.thickness, kLadderPoisson, one.joint);
  const double closed = closedFormTurn(one.ladder, one.thickness, one.joint);
  const auto percentOff = [&](double turn) { return 100 * (turn / closed - 1); };
  return fmt::format("| {:g} / {:g} | {:g} | {:g} | {:.5f} | {:+.2f} | {:+.2f} | {:+.2f} |\n",
                     100 * one.ladder.bottomShrink, 100 * one.ladder.topShrink, one.thickness,
                     one.joint.radius, closed,
                     percentOff(innerTurn(frame, MultigridSolver(device, frame).solve({}))),
                     percentOff(innerTurn(frame, solveFrame(frame, {}))),
                     percentOff(innerTurn(springs, MultigridSolver(device, springs).solve({}))));
}

}  // namespace

std::string circleTable() {
  std::string table =
      "| bars | tip to root, of the length | diameter x pi / length - 1 | turn short of 2 pi, rad "
      "|\n"
      "| --- | --- | --- | --- |\n";
  for (const int pieces : {8, 16, 32}) {
    const NetworkState state = rolledChain(pieces);
    const double gap = (state.positions.col(pieces) - state.positions.col(0)).norm();
    const double diameter =
        (state.positions.col(pieces / 2) - state.positions.col(0)).norm() * std::numbers::pi;
    const double turn = 2 * std::acos(std::min(1.0, std::abs(state.rotations(3, pieces))));
    table += fmt::format("| {} | {:.1e} | {:+.1e} | {:.1e} |\n", pieces, gap, diameter - 1, turn);
  }
  return table;
}

std::string ladderTable(const Device& device) {
  std::string table =
      "| shrink, % | t | r / t | closed form, rad | `multigrid`, % off | `reference`, % off | "
      "springs, % off |\n| --- | --- | --- | --- | --- | --- | --- |\n";
  for (const LadderCase& one : kLadderCases) {
    table += ladderRow(device, one);
  }
  return table;
}

}  // namespace morphgrid
