#include "app/checkpoint_keeper.h"

#include <spdlog/spdlog.h>

#include "core/error.h"

namespace morphgrid {

CheckpointKeeper::CheckpointKeeper(CheckpointOptions options, ProblemIdentity problem)
    : options_(std::move(options)), problem_(std::move(problem)) {}

void CheckpointKeeper::resume(Checkpoint checkpoint) {
  inPlane_ = std::move(checkpoint.inPlane);
  full_ = std::move(checkpoint.full);
  latest_ = std::move(checkpoint.solve);
  inverse_ = std::move(checkpoint.inverse);
}

void CheckpointKeeper::keep(SolveCheckpoint solve) {
  if (ended_) {
    return;
  }
  latest_ = std::move(solve);
  saveWhenDue();
}

void CheckpointKeeper::keep(InverseCheckpoint inverse) {
  inverse_ = std::move(inverse);
  saveWhenDue();
}

void CheckpointKeeper::saveWhenDue() {
  const std::chrono::duration<double> pause = Clock::now() - lastSaved_;
  if (pause.count() >= 60 * options_.minutes) {
    save();
  }
}

void CheckpointKeeper::endSolve(const Equilibrium& result) {
  if (!result.converged && !ended_) {
    save();
  }
  ended_ = ended_ || result.reason == StopReason::interrupted ||
           result.reason == StopReason::deviceFailure;
}

void CheckpointKeeper::beginFullStage(const Equilibrium& inPlane) {
  inPlane_ = inPlane;
  latest_.reset();
}

void CheckpointKeeper::beginInverseDesign(const Equilibrium& full) {
  full_ = full;
  latest_.reset();
}

void CheckpointKeeper::endInverseDesign(bool early) {
  if (early) {
    save();
  }
}

void CheckpointKeeper::save() {
  if (options_.file.empty() || !(latest_ || inverse_)) {
    return;
  }
  // A full disk must not end a long solve; it may have room the next time.
  try {
    writeCheckpoint(options_.file, {problem_, inPlane_, full_, latest_, inverse_});
  } catch (const InputError& error) {
    spdlog::warn(error.what());
  }
  lastSaved_ = Clock::now();
}

}  // namespace morphgrid
