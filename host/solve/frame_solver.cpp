#include "solve/frame_solver.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "energy/frame_energy.h"
#include "energy/grid_energy.h"
#include "solve/checkpoint_pace.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;
using Clock = std::chrono::steady_clock;
using Definiteness = FrameEnergy::Definiteness;

constexpr double kLargestMove = 2;    // Spacings, of any joint in one step.
constexpr double kLargestTurn = 0.5;  // Radians
constexpr int kLineSearchSteps = 40;
constexpr double kSufficientDecrease = 1e-4;
// Where the energy's rounding hides its decrease.
constexpr double kEnergyRounding = 1e-13;
// Steps in which some joint moves by so many spacings are far from a saddle: bars' positive parts.
constexpr double kFarMove = 0.1;
// Of the way out of a saddle.
constexpr double kEscape = 0.05;
constexpr int kMostEscapes = 10;
// Of the diagonal's mean: what holds the six rigid motions, which cost no energy.
constexpr double kHold = 1e-10;
constexpr double kLeastShift = 1e-7;
constexpr double kLargestShift = 1e3;
constexpr double kShiftGrowth = 4;

/// A joint's displacement in spacings and its turn in radians, one after the other.
VectorXd scaledUnknowns(const Matrix3Xd& gradient, double spacing) {
  const Eigen::Index count = gradient.cols() / 2;
  VectorXd result(6 * count);
  for (Eigen::Index n = 0; n < count; ++n) {
    result.segment<3>(6 * n) = spacing * gradient.col(n);
    result.segment<3>(6 * n + 3) = gradient.col(count + n);
  }
  return result;
}

struct Place {
  Matrix3Xd positions;
  JointRotations rotations;

  /// step: scaled, as scaledUnknowns().
  Place moved(const VectorXd& step, double length, double spacing) const {
    Place result = *this;
    for (Eigen::Index n = 0; n < positions.cols(); ++n) {
      result.positions.col(n) += length * spacing * step.segment<3>(6 * n);
      const Eigen::Vector3d turn = length * step.segment<3>(6 * n + 3);
      const double angle = turn.norm();
      if (angle > 0) {
        const Eigen::Quaterniond by(Eigen::AngleAxisd(angle, turn / angle));
        const Eigen::Quaterniond now(result.rotations.col(n));
        result.rotations.col(n) = (by * now).normalized().coeffs();
      }
    }
    return result;
  }
};

class FrameNewton {
 public:
  FrameNewton(const StrutGrid& grid) : energy_(grid), spacing_(grid.spacing) {}

  FrameEnergy::Value evaluate(const Place& place) const {
    return energy_.evaluate(place.positions, place.rotations);
  }

  /// Downhill, scaled.
  VectorXd direction(const Place& place, const VectorXd& gradient) {
    Eigen::SparseMatrix<double> hessian = scaledHessian(place, Definiteness::exact);
    hold(hessian, kHold);
    if (factorise(hessian)) {
      return -factor_.solve(gradient);
    }
    if (lastMove_ > kFarMove) {
      hessian = scaledHessian(place, Definiteness::positiveParts);
      hold(hessian, kHold);
      if (factorise(hessian)) {
        return -factor_.solve(gradient);
      }
    }
    return shiftedDirection(scaledHessian(place, Definiteness::exact), gradient);
  }

  /// Scaled; a motion from a saddle along which the energy falls, its largest move `kEscape`
  /// spacings or radians; none at a minimum.
  std::optional<VectorXd> escapeFrom(const Place& place) {
    Eigen::SparseMatrix<double> hessian = scaledHessian(place, Definiteness::exact);
    hold(hessian, kHold);
    factorise(hessian);
    const VectorXd pivots = factor_.vectorD();
    Eigen::Index least = 0;
    if (factor_.info() != Eigen::Success || pivots.minCoeff(&least) > 0) {
      return std::nullopt;
    }
    // With P H P^T = L D L^T, y = P^T L^-T e gives y . H y = D_e.
    const VectorXd unit = VectorXd::Unit(pivots.size(), least);
    const VectorXd permuted = factor_.matrixU().solve(unit);
    const VectorXd motion = factor_.permutationPinv() * permuted;
    return kEscape / motion.cwiseAbs().maxCoeff() * motion;
  }

  /// The longest step allowed along a direction.
  double longestStep(const VectorXd& direction) {
    double move = 0, turn = 0;
    for (Eigen::Index n = 0; n < direction.size(); n += 6) {
      move = std::max(move, direction.segment<3>(n).norm());
      turn = std::max(turn, direction.segment<3>(n + 3).norm());
    }
    lastMove_ = move;
    return std::min({1.0, kLargestMove / move, kLargestTurn / turn});
  }

 private:
  Eigen::SparseMatrix<double> scaledHessian(const Place& place, Definiteness definiteness) const {
    Eigen::SparseMatrix<double> hessian =
        energy_.hessian(place.positions, place.rotations, definiteness);
    VectorXd scale = VectorXd::Ones(hessian.rows());
    for (Eigen::Index n = 0; n < scale.size(); n += 6) {
      scale.segment<3>(n).setConstant(spacing_);
    }
    return scale.asDiagonal() * hessian * scale.asDiagonal();
  }

  static void hold(Eigen::SparseMatrix<double>& hessian, double share) {
    const double mean = hessian.diagonal().cwiseAbs().mean();
    for (Eigen::Index n = 0; n < hessian.rows(); ++n) {
      hessian.coeffRef(n, n) += share * mean;
    }
  }

  bool factorise(const Eigen::SparseMatrix<double>& hessian) {
    if (!isAnalysed_) {
      factor_.analyzePattern(hessian);
      isAnalysed_ = true;
    }
    factor_.factorize(hessian);
    return factor_.info() == Eigen::Success && factor_.vectorD().minCoeff() > 0;
  }

  VectorXd shiftedDirection(const Eigen::SparseMatrix<double>& hessian, const VectorXd& gradient) {
    for (shift_ = std::max(kLeastShift, shift_ / (kShiftGrowth * kShiftGrowth));
         shift_ < kLargestShift; shift_ *= kShiftGrowth) {
      Eigen::SparseMatrix<double> shifted = hessian;
      hold(shifted, shift_);
      if (factorise(shifted)) {
        return -factor_.solve(gradient);
      }
    }
    return -gradient;
  }

  FrameEnergy energy_;
  double spacing_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
  bool isAnalysed_ = false;
  double lastMove_ = 1 / kHold;
  double shift_ = 0;
};

/// Backtracking until the energy falls enough; nothing when no step does.
std::optional<Place> searchLine(const FrameNewton& newton, const Place& place,
                                const VectorXd& direction, double longest, double energy,
                                double slope, double spacing) {
  double length = longest;
  for (int attempt = 0; attempt < kLineSearchSteps; ++attempt, length /= 2) {
    Place trial = place.moved(direction, length, spacing);
    const double allowed =
        energy + kSufficientDecrease * length * slope + kEnergyRounding * std::abs(energy);
    if (newton.evaluate(trial).energy <= allowed) {
      return trial;
    }
  }
  return std::nullopt;
}

}  // namespace

Equilibrium solveFrame(const StrutGrid& grid, const SolveOptions& options) {
  validate(grid);
  if (!grid.bars) {
    throw InputError("the grid has springs, not bars that are welded");
  }
  auto start = Clock::now();
  const GridEnergy judge(grid);
  FrameNewton newton(grid);
  Equilibrium result;
  Place place{grid.positions, unturnedJoints(grid.shape.vertexCount())};
  if (const auto& from = options.resumeFrom) {
    if (from->positions.cols() != place.positions.cols()) {
      throw InputError(fmt::format("the checkpoint's {} positions are not of this grid",
                                   from->positions.cols()));
    }
    const bool hasRotations = from->rotations.cols() == from->positions.cols();
    place = {from->positions, hasRotations ? from->rotations : turnWithBars(grid, from->positions)};
    result.iterations = static_cast<long>(from->iterations);
    result.history = from->history;
    start -=
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(from->seconds));
  }
  CheckpointPace<SolveCheckpoint> pace(options.onCheckpoint);
  int escapes = 0;
  for (;; ++result.iterations) {
    const FrameEnergy::Value value = newton.evaluate(place);
    result.positions = place.positions;
    result.rotations = place.rotations;
    result.energy = value.energy;
    result.residual = judge.evaluate(place.positions, place.rotations).residual;
    result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    result.converged = result.residual <= options.tolerance;
    if (result.converged && escapes < kMostEscapes) {
      if (const auto motion = newton.escapeFrom(place)) {
        ++escapes;
        Place forth = place.moved(*motion, 1, grid.spacing);
        Place back = place.moved(*motion, -1, grid.spacing);
        const bool goesForth = newton.evaluate(forth).energy <= newton.evaluate(back).energy;
        place = goesForth ? std::move(forth) : std::move(back);
        continue;
      }
    }
    result.history.push_back({result.iterations, result.energy, result.residual, result.seconds});
    if (options.onPositions) {
      options.onPositions(place.positions);
    }
    if (options.onProgress) {
      options.onProgress(result.history.back());
    }
    const bool isLast = result.converged || result.iterations >= options.iterationLimit;
    const bool interrupted = options.stopRequested();
    pace.offer(0, isLast || interrupted, [&] {
      return SolveCheckpoint{0,
                             place.positions,
                             place.rotations,
                             static_cast<double>(result.iterations),
                             result.seconds,
                             result.history};
    });
    if (isLast || interrupted) {
      result.reason = result.converged ? StopReason::residual
                      : interrupted    ? StopReason::interrupted
                                       : StopReason::iterationLimit;
      return result;
    }
    const VectorXd gradient = scaledUnknowns(value.gradient, grid.spacing);
    const VectorXd direction = newton.direction(place, gradient);
    auto next = searchLine(newton, place, direction, newton.longestStep(direction), value.energy,
                           direction.dot(gradient), grid.spacing);
    if (!next) {
      result.reason = StopReason::stagnated;
      return result;
    }
    place = std::move(*next);
  }
}

}  // namespace morphgrid
