#include "solve/jacobi_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "core/error.h"
#include "energy/strut_energy.h"
#include "solve/checkpoint_pace.h"
#include "solve/control_comp.h"
#include "solve/energy_left.h"
#include "solve/loaded_rest.h"
#include "solve/preconditioners.h"
#include "solve/sweep_comp.h"
#include "solve/sweep_precise_comp.h"

namespace morphgrid {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kLoadSteps = 10;
constexpr double kLoadTolerance = 3e-6;  // Residual at which the next load step is taken.
constexpr long kLoadSweeps = 2000;       // It is taken after this many sweeps at the latest.
// Well above what rounding in single precision leaves of the residual; below it doubles take over.
constexpr double kSinglePrecisionResidual = 1e-6;
constexpr int kLargestSubmission = 64;  // Checks recorded at once.
constexpr double kSubmissionSeconds = 0.1;
constexpr long kPatience = 20000;  // Sweeps without a new best residual that end the run.

Buffer hostStorage(const Device& device, std::size_t bytes) {
  return {device, bytes, BufferUsage::storageBuffer, MemoryKind::host};
}

}  // namespace

JacobiSolver::JacobiSolver(const Device& device, const StrutGrid& grid, DeviceGrid& deviceGrid)
    : device_(device),
      grid_(grid),
      deviceGrid_(deviceGrid),
      energy_(grid),
      walk_(device, deviceGrid, kSweepBlockV),
      state_(hostStorage(device, sizeof(SolverState))),
      partials_(device,
                walk_.groupsU() * static_cast<std::uint32_t>(grid.shape.verticesV) * sizeof(vec4),
                BufferUsage::storageBuffer, MemoryKind::device),
      samples_(hostStorage(device, kLargestSubmission * sizeof(SolverSample))),
      positionsView_(integerTexels(device, deviceGrid.positions())),
      previousView_(integerTexels(device, deviceGrid.previousPositions())),
      texels_(device, deviceGrid),
      sweeps_(sweepKernels(sweep_comp_spirv, walk_)),
      control_(
          device, control_comp_spirv,
          {{kBindingState, &state_}, {kBindingPartials, &partials_}, {kBindingSamples, &samples_}},
          sizeof(ControlPush)),
      stream_(device) {}

JacobiSolver::SweepKernels JacobiSolver::sweepKernels(ShaderCode spirv,
                                                      const ColumnWalk& walk) const {
  // From `from` to the buffer that `previous` is a view of.
  const auto resources = [&](const TexelView& from, const TexelView& previous,
                             const Buffer& to) -> std::vector<KernelResource> {
    std::vector<KernelResource> all{{kBindingPositions, &from},
                                    {kBindingPreviousPositions, &previous},
                                    {kBindingNextPositions, &to},
                                    {kBindingState, &state_},
                                    {kBindingPartials, &partials_}};
    texels_.appendTo(all);
    return all;
  };
  const auto forth = resources(positionsView_, previousView_, deviceGrid_.previousPositions());
  const auto back = resources(previousView_, positionsView_, deviceGrid_.positions());
  ComputeKernel even(device_, spirv, forth, sizeof(SweepPush), walk.constants(false));
  ComputeKernel odd(device_, even, back);
  ComputeKernel measured(device_, spirv, back, sizeof(SweepPush), walk.constants(true));
  return {std::move(even), std::move(odd), std::move(measured), walk};
}

const JacobiSolver::SweepKernels& JacobiSolver::preciseSweeps() {
  if (!preciseSweeps_) {
    const ColumnWalk walk(device_, deviceGrid_, kPreciseSweepBlockV);
    preciseSweeps_.emplace(sweepKernels(sweep_precise_comp_spirv, walk));
  }
  return *preciseSweeps_;
}

void JacobiSolver::record(const SweepKernels& kernels, int sweeps) {
  const double residualScale =
      1 / (2 * energy_.constraintWeights().mean() * std::sqrt(double(grid_.shape.vertexCount())));
  const ControlPush controlPush{kernels.walk.groupCount(), kLargestSubmission,
                                static_cast<float>(residualScale)};
  const std::uint32_t groupsU = kernels.walk.groupsU();
  const std::uint32_t groupsV = kernels.walk.groupsV();
  SweepPush push{kernels.walk.push(), 0};
  stream_.begin();
  for (int n = 0; n < sweeps; ++n) {
    push.sweep = static_cast<std::uint32_t>(n) % kSweepsPerCheck;
    if (push.sweep + 1 < kSweepsPerCheck) {
      stream_.dispatch(n % 2 == 0 ? kernels.even : kernels.odd, push, groupsU, groupsV);
    } else {
      stream_.dispatch(kernels.measured, push, groupsU, groupsV);
      stream_.dispatch(control_, controlPush, 1);
    }
  }
  if (sweeps % 2 == 1) {
    stream_.copy(deviceGrid_.previousPositions(), deviceGrid_.positions(),
                 deviceGrid_.positions().bytes());
  }
  stream_.end();
}

void JacobiSolver::resetState(double tolerance) {
  state_.mapped<SolverState>()[0] = {0, 0, 0, static_cast<float>(tolerance)};
}

void JacobiSolver::sweep(int count, bool precise) {
  record(precise ? preciseSweeps() : sweeps_, count);
  resetState(0);
  stream_.submitAndWait();
}

/// What has happened since solve() began, and whether to go on.
class JacobiSolver::RunLog {
 public:
  RunLog(const SolveOptions& options, double energyScale)
      : options_(options), pace_(options.onCheckpoint), energyScale_(energyScale) {
    if (const auto& from = options.resumeFrom) {
      sweeps_ = static_cast<long>(from->iterations);
      start_ -=
          std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(from->seconds));
      history_ = from->history;
    }
  }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  long sweeps() const { return sweeps_; }
  std::vector<ConvergenceSample>& history() { return history_; }

  void add(const SolverSample& sample) {
    sweeps_ += kSweepsPerCheck;
    if (!std::isfinite(sample.energy) || !std::isfinite(sample.residual)) {
      throw DeviceError(
          fmt::format("the solve left the range of numbers at sweep {}; weights, or lengths, that "
                      "differ less may do",
                      sweeps_));
    }
    history_.push_back({sweeps_, sample.energy * energyScale_, sample.residual, seconds()});
    if (sample.residual < 0.9 * bestResidual_) {
      bestResidual_ = sample.residual;
      bestSweep_ = sweeps_;
    }
  }

  void beginLoadStep(int step) { loadStep_ = step; }

  void offerCheckpoint(const DeviceGrid& grid) {
    pace_.offer(loadStep_, reasonToStop().has_value(), [&] {
      return SolveCheckpoint{loadStep_, grid.downloadPositions(),
                             {},        static_cast<double>(sweeps_),
                             seconds(), history_};
    });
  }

  /// A new problem begins: its residuals are not comparable with those before.
  void forgetBest() {
    bestResidual_ = std::numeric_limits<double>::infinity();
    bestSweep_ = sweeps_;
  }

  void report() const {
    if (options_.onProgress && !history_.empty()) {
      options_.onProgress(history_.back());
    }
  }

  /// Why the whole solve must end now, if it must.
  std::optional<StopReason> reasonToStop() const {
    if (options_.stopRequested()) {
      return StopReason::interrupted;
    }
    if (sweeps_ >= options_.iterationLimit) {
      return StopReason::iterationLimit;
    }
    if (sweeps_ - bestSweep_ > kPatience) {
      return StopReason::stagnated;
    }
    return std::nullopt;
  }

 private:
  const SolveOptions& options_;
  CheckpointPace<SolveCheckpoint> pace_;
  double energyScale_;
  int loadStep_ = 0;
  Clock::time_point start_ = Clock::now();
  long sweeps_ = 0;
  double bestResidual_ = std::numeric_limits<double>::infinity();
  long bestSweep_ = 0;
  std::vector<ConvergenceSample> history_;
};

void JacobiSolver::runUntil(const SweepKernels& kernels, double tolerance, long sweepLimit,
                            RunLog& log) {
  resetState(tolerance);
  log.forgetBest();
  const long end = log.sweeps() + sweepLimit;
  int checks = 4;
  while (!log.reasonToStop() && log.sweeps() < end) {
    const double before = log.seconds();
    const auto left = (end - log.sweeps() + kSweepsPerCheck - 1) / kSweepsPerCheck;
    record(kernels, static_cast<int>(std::min<long>(checks, left) * kSweepsPerCheck));
    state_.mapped<SolverState>()[0].sampleCount = 0;
    stream_.submitAndWait();
    const SolverState state = state_.mapped<SolverState>()[0];
    for (std::uint32_t n = 0; n < state.sampleCount; ++n) {
      log.add(samples_.mapped<SolverSample>()[n]);
    }
    log.report();
    log.offerCheckpoint(deviceGrid_);
    if (state.done != 0) {
      return;
    }
    if (log.seconds() - before < kSubmissionSeconds / 2) {
      checks = std::min(2 * checks, kLargestSubmission);
    }
  }
}

int JacobiSolver::start(const std::optional<SolveCheckpoint>& from) {
  if (!from) {
    return 1;
  }
  if (from->phase < 1 || from->phase > kLoadSteps ||
      from->positions.cols() != grid_.shape.vertexCount()) {
    throw InputError(
        fmt::format("the checkpoint's {} positions at load step {} are not of this grid",
                    from->positions.cols(), from->phase));
  }
  deviceGrid_.uploadPositions(from->positions);
  return from->phase;
}

Equilibrium JacobiSolver::solve(const SolveOptions& options) {
  RunLog log(options, grid_.spacing * grid_.spacing);
  Equilibrium result;
  for (int step = start(options.resumeFrom); step < kLoadSteps && !log.reasonToStop(); ++step) {
    log.beginLoadStep(step);
    deviceGrid_.uploadRest(loadedRest(grid_, double(step) / kLoadSteps));
    runUntil(sweeps_, std::max(kLoadTolerance, options.tolerance), kLoadSweeps, log);
  }
  log.beginLoadStep(kLoadSteps);
  deviceGrid_.uploadRest(grid_.rest);
  const SweepKernels& finalSweeps = device_.hasFloat64() ? preciseSweeps() : sweeps_;
  if (options.tolerance < kSinglePrecisionResidual) {
    runUntil(sweeps_, kSinglePrecisionResidual, options.iterationLimit - log.sweeps(), log);
  }
  // The device may see a slightly other residual than the host in double: the host decides.
  double tolerance = options.tolerance;
  while (!result.converged) {
    runUntil(finalSweeps, tolerance, options.iterationLimit - log.sweeps(), log);
    result.positions = deviceGrid_.downloadPositions();
    const StrutEnergy::Value value = energy_.evaluate(result.positions);
    result.energy = value.energy;
    result.residual = energy_.residual(value.gradient);
    // A residual in units of the mean stiffness says nothing about what is much softer.
    double excess = 1;
    if (result.residual <= options.tolerance) {
      excess = energyExcess(grid_, result.positions, options.energyTolerance,
                            vCyclePreconditioner(device_, deviceGrid_));
      result.converged = excess <= 1;
    }
    if (const auto reason = log.reasonToStop()) {
      result.reason = *reason;
      break;
    }
    tolerance = tightened(tolerance, excess);
  }
  if (result.converged) {
    result.reason = StopReason::residual;
  }
  result.iterations = log.sweeps();
  result.seconds = log.seconds();
  result.history = std::move(log.history());
  result.history.push_back({result.iterations, result.energy, result.residual, result.seconds});
  return result;
}

}  // namespace morphgrid
