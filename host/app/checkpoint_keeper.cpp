#include "app/checkpoint_keeper.h"

#include <spdlog/spdlog.h>

#include "core/error.h"

namespace morphgrid {

CheckpointKeeper::CheckpointKeeper(CheckpointOptions options,
                                   std::map<std::string, std::string> settings)
    : options_(std::move(options)), settings_(std::move(settings)) {}

void CheckpointKeeper::resume(Checkpoint checkpoint) {
  inPlane_ = std::move(checkpoint.inPlane);
  latest_ = std::move(checkpoint.solve);
}

void CheckpointKeeper::keep(SolveCheckpoint solve) {
  if (ended_) {
    return;
  }
  latest_ = std::move(solve);
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

void CheckpointKeeper::save() {
  if (options_.file.empty() || !latest_) {
    return;
  }
  // A full disk must not end a long solve; it may have room the next time.
  try {
    writeCheckpoint(options_.file, {settings_, inPlane_, *latest_});
  } catch (const InputError& error) {
    spdlog::warn(error.what());
  }
  lastSaved_ = Clock::now();
}

}  // namespace morphgrid
