#include "benchmark/bar_network.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "energy/frame_energy.h"
#include "grid/bar_section.h"

namespace morphgrid {
namespace {

using Matrix9d = Eigen::Matrix<double, 9, 9>;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

constexpr int kMostSteps = 60;
// Of displacements, in the unit of length, and turns.
constexpr double kSmallestStep = 1e-7;
constexpr double kLargestStep = 0.5;
constexpr int kRollSteps = 20;
constexpr double kChainThickness = 0.02;

/// Energy's derivatives by displacement and turn of every joint but the first.
struct Derivatives {
  VectorXd gradient;
  Eigen::SparseMatrix<double> hessian;  ///< Lower half
};

Derivatives derivativesAt(const BarNetwork& network, const NetworkState& state) {
  const Eigen::Index unknowns = 6 * (state.positions.cols() - 1);
  Derivatives result{VectorXd(unknowns), Eigen::SparseMatrix<double>(unknowns, unknowns)};
  for (Eigen::Index n = 1; n < state.positions.cols(); ++n) {
    result.gradient.segment<6>(6 * (n - 1)) << Eigen::Vector3d::Zero(), -network.moments.col(n);
  }
  // From (displacement, turn) of either end to the nine unknowns of a bar.
  Eigen::Matrix<double, 9, 12> spread = Eigen::Matrix<double, 9, 12>::Zero();
  spread.block<3, 3>(0, 0) = -Eigen::Matrix3d::Identity();
  spread.block<3, 3>(0, 6).setIdentity();
  spread.block<3, 3>(3, 3).setIdentity();
  spread.block<3, 3>(6, 9).setIdentity();
  const FramePlacement place{state.positions, state.rotations};
  std::vector<Eigen::Triplet<double>> entries;
  for (const BarNetwork::Bar& bar : network.bars) {
    const auto ends = place.endsOf(bar.term, bar.edge);
    const Matrix9d exact = bar.term.hessian(ends);
    const Eigen::Matrix<double, 12, 12> block =
        spread.transpose() * ((exact + exact.transpose()) / 2) * spread;
    const Eigen::Matrix<double, 12, 1> gradient =
        spread.transpose() * bar.term.evaluate(ends).gradient;
    const auto unknown = [&](int n) {
      return 6 * ((n < 6 ? bar.edge.from : bar.edge.to) - 1) + n % 6;
    };
    for (int row = 0; row < 12; ++row) {
      if (unknown(row) < 0) continue;
      result.gradient[unknown(row)] += gradient[row];
      for (int column = 0; column < 12; ++column) {
        if (unknown(column) >= 0 && unknown(row) >= unknown(column)) {
          entries.emplace_back(unknown(row), unknown(column), block(row, column));
        }
      }
    }
  }
  result.hessian.setFromTriplets(entries.begin(), entries.end());
  return result;
}

void move(NetworkState& state, const VectorXd& step) {
  for (Eigen::Index n = 1; n < state.positions.cols(); ++n) {
    state.positions.col(n) += step.segment<3>(6 * (n - 1));
    const Eigen::Vector3d turn = step.segment<3>(6 * (n - 1) + 3);
    const Eigen::Quaterniond by(Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()));
    const Eigen::Quaterniond now(state.rotations.col(n));
    state.rotations.col(n) = (by * now).normalized().coeffs();
  }
}

}  // namespace

NetworkState solveNetwork(const BarNetwork& network, NetworkState start) {
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor;
  for (int n = 0; n < kMostSteps; ++n) {
    const Derivatives at = derivativesAt(network, start);
    factor.compute(at.hessian);
    const VectorXd step = -factor.solve(at.gradient);
    move(start, step * std::min(1.0, kLargestStep / step.cwiseAbs().maxCoeff()));
    if (step.cwiseAbs().maxCoeff() < kSmallestStep) {
      return start;
    }
  }
  throw std::runtime_error("Newton's method does not converge on a network of bars");
}

NetworkState rolledChain(int pieces) {
  const double length = 1.0 / pieces;
  const BarSection section = rectangularSection(
      {.width = kChainThickness, .height = kChainThickness, .isShearing = false}, 1);
  BarNetwork network{{}, Matrix3Xd::Zero(3, pieces + 1)};
  NetworkState state{Matrix3Xd::Zero(3, pieces + 1), unturnedJoints(pieces + 1)};
  for (int n = 0; n < pieces; ++n) {
    network.bars.push_back(
        {{section, length, BeamTerm::axesOf(Eigen::Vector3d::UnitX(), true)}, {n, n + 1}});
    state.positions(0, n + 1) = length * (n + 1);
  }
  for (int n = 1; n <= kRollSteps; ++n) {
    network.moments(1, pieces) = 2 * std::numbers::pi * section.bendingB * n / kRollSteps;
    state = solveNetwork(network, std::move(state));
  }
  return state;
}

BarNetwork halvedBars(const StrutGrid& grid) {
  BarNetwork network;
  int next = grid.shape.vertexCount();
  BeamTerm::forEach(grid, [&](const BeamTerm& term, const Edge& edge) {
    const BeamTerm half{term.section, term.rest / 2, term.printed};
    network.bars.push_back({half, {edge.from, next}});
    network.bars.push_back({half, {next, edge.to}});
    ++next;
  });
  network.moments = Matrix3Xd::Zero(3, next);
  return network;
}

NetworkState halvedState(const StrutGrid& grid, const NetworkState& state) {
  const int joints = grid.shape.vertexCount();
  const int count = joints + grid.shape.strutCount();
  NetworkState result{Matrix3Xd(3, count), JointRotations(4, count)};
  result.positions.leftCols(joints) = state.positions;
  result.rotations.leftCols(joints) = state.rotations;
  int next = joints;
  forEachStrut(grid.shape, [&](const Strut& strut) {
    // The cubic between the ends (Hermite), whose middle is turned as they are in the mean but runs
    // along the cubic.
    const Eigen::Vector3d printed = printedDirection(*grid.bars, strut);
    const Eigen::Quaterniond a(state.rotations.col(strut.from));
    const Eigen::Quaterniond b(state.rotations.col(strut.to));
    const Eigen::Vector3d chord = state.positions.col(strut.to) - state.positions.col(strut.from);
    result.positions.col(next) = state.positions.col(strut.from) + chord / 2 +
                                 chord.norm() / 8 * (a * printed - b * printed);
    const Eigen::Vector3d along = 6 * chord.normalized() - a * printed - b * printed;
    const Eigen::Quaterniond mean = a.slerp(0.5, b);
    result.rotations.col(next) =
        (Eigen::Quaterniond::FromTwoVectors(mean * printed, along) * mean).coeffs();
    ++next;
  });
  return result;
}

}  // namespace morphgrid
