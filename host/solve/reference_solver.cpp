#include "solve/reference_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <limits>
#include <optional>

#include "core/error.h"
#include "energy/constant_matrix.h"
#include "energy/strut_energy.h"
#include "solve/checkpoint_pace.h"
#include "solve/energy_left.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kRememberedPairs = 8;
constexpr int kLineSearchSteps = 30;
constexpr double kSufficientDecrease = 1e-4;
// Near the minimum the energy's rounding hides its decrease; there the slope decides (approximate
// Wolfe condition, Hager & Zhang 2005).
constexpr double kEnergyRounding = 1e-13;
constexpr long kPatience = 300;  // Iterations without progress that end the run.
// Where a grid unrolls, its energy falls long before its residual does: so much less is progress.
constexpr double kProgressOfEnergy = 1e-6;
constexpr double kLargestMove = 2;  // Spacings that a vertex may move in one step.
constexpr long kSampleEvery = 10;

double dot(const Matrix3Xd& a, const Matrix3Xd& b) { return a.cwiseProduct(b).sum(); }

/// The two-loop recursion (Nocedal & Wright, algorithm 7.4).
class LimitedMemory {
 public:
  void clear() { pairs_.clear(); }
  bool empty() const { return pairs_.empty(); }

  void add(Matrix3Xd step, Matrix3Xd gradientChange) {
    const double curvature = dot(step, gradientChange);
    if (curvature <= 0) {
      return;
    }
    pairs_.push_back({std::move(step), std::move(gradientChange), 1 / curvature});
    if (pairs_.size() > kRememberedPairs) {
      pairs_.pop_front();
    }
  }

  Matrix3Xd direction(const Matrix3Xd& gradient, const ConstantMatrix& matrix) const {
    Matrix3Xd q = gradient;
    std::vector<double> alpha(pairs_.size());
    for (std::size_t n = pairs_.size(); n-- > 0;) {
      alpha[n] = pairs_[n].inverse * dot(pairs_[n].step, q);
      q -= alpha[n] * pairs_[n].change;
    }
    q = matrix.solve(q);
    for (std::size_t n = 0; n < pairs_.size(); ++n) {
      const double beta = pairs_[n].inverse * dot(pairs_[n].change, q);
      q += (alpha[n] - beta) * pairs_[n].step;
    }
    return -q;
  }

 private:
  struct Pair {
    Matrix3Xd step;
    Matrix3Xd change;
    double inverse;
  };
  std::deque<Pair> pairs_;
};

struct Trial {
  Matrix3Xd positions;
  StrutEnergy::Value value;
};

/// Backtracking until the energy falls enough; nothing when no step does.
std::optional<Trial> searchLine(const StrutEnergy& energy, const Matrix3Xd& positions,
                                const StrutEnergy::Value& at, const Matrix3Xd& direction,
                                double spacing) {
  const double slope = dot(direction, at.gradient);
  if (slope >= 0) {
    return std::nullopt;
  }
  const double longest = direction.colwise().norm().maxCoeff();
  double step = std::min(1.0, kLargestMove * spacing / longest);
  for (int attempt = 0; attempt < kLineSearchSteps; ++attempt, step *= 0.5) {
    Matrix3Xd candidate = positions + step * direction;
    StrutEnergy::Value value = energy.evaluate(candidate);
    const bool decreases = value.energy <= at.energy + kSufficientDecrease * step * slope;
    const bool flattens = value.energy <= at.energy * (1 + kEnergyRounding) &&
                          dot(direction, value.gradient) <= (2 * kSufficientDecrease - 1) * slope;
    if (decreases || flattens) {
      return Trial{std::move(candidate), std::move(value)};
    }
  }
  return std::nullopt;
}

}  // namespace

Equilibrium solveReference(const StrutGrid& grid, const SolveOptions& options) {
  validate(grid);
  auto start = Clock::now();
  const StrutEnergy energy(grid);
  const ConstantMatrix matrix(grid);
  LimitedMemory memory;

  Equilibrium result;
  result.positions = grid.positions;
  if (const auto& from = options.resumeFrom) {
    if (from->positions.cols() != grid.shape.vertexCount()) {
      throw InputError(fmt::format("the checkpoint's {} positions are not of this grid",
                                   from->positions.cols()));
    }
    result.positions = from->positions;
    result.iterations = static_cast<long>(from->iterations);
    result.history = from->history;
    start -=
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(from->seconds));
  }
  CheckpointPace<SolveCheckpoint> pace(options.onCheckpoint);
  StrutEnergy::Value value = energy.evaluate(result.positions);
  double bestResidual = std::numeric_limits<double>::infinity();
  double bestEnergy = std::numeric_limits<double>::infinity();
  long bestIteration = result.iterations;
  double bound = options.tolerance;  // Lower where the energy does not rest at it.
  for (;; ++result.iterations) {
    result.energy = value.energy;
    result.residual = energy.residual(value.gradient);
    result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (result.residual <= bound) {
      const double excess =
          energyExcess(grid, result.positions, options.energyTolerance,
                       [&](const Matrix3Xd& right) { return matrix.solve(right); });
      result.converged = excess <= 1;
      bound = tightened(result.residual, excess);
    }
    const bool last = result.converged || result.iterations >= options.iterationLimit;
    if (last || result.iterations % kSampleEvery == 0) {
      result.history.push_back({result.iterations, result.energy, result.residual, result.seconds});
      if (options.onPositions) {
        options.onPositions(result.positions);
      }
      if (options.onProgress) {
        options.onProgress(result.history.back());
      }
    }
    const bool fallsResidual = result.residual < 0.9 * bestResidual;
    if (fallsResidual || value.energy < (1 - kProgressOfEnergy) * bestEnergy) {
      bestResidual = std::min(bestResidual, result.residual);
      bestEnergy = value.energy;
      bestIteration = result.iterations;
    }
    const bool interrupted = options.stopRequested();
    pace.offer(0, last || interrupted, [&] {
      return SolveCheckpoint{0,
                             result.positions,
                             {},
                             static_cast<double>(result.iterations),
                             result.seconds,
                             result.history};
    });
    if (last) {
      result.reason = result.converged ? StopReason::residual : StopReason::iterationLimit;
      return result;
    }
    if (interrupted) {
      result.reason = StopReason::interrupted;
      return result;
    }
    auto trial = searchLine(energy, result.positions, value,
                            memory.direction(value.gradient, matrix), grid.spacing);
    if (!trial && !memory.empty()) {
      memory.clear();
      trial = searchLine(energy, result.positions, value, memory.direction(value.gradient, matrix),
                         grid.spacing);
    }
    if (!trial || result.iterations - bestIteration > kPatience) {
      result.reason = StopReason::stagnated;
      return result;
    }
    memory.add(trial->positions - result.positions, trial->value.gradient - value.gradient);
    result.positions = std::move(trial->positions);
    value = std::move(trial->value);
  }
}

}  // namespace morphgrid
