#pragma once
#include <chrono>

#include "app/checkpoint.h"

namespace morphgrid {

struct CheckpointOptions {
  std::filesystem::path file;  ///< Empty: none is written.
  double minutes = 5;          ///< Between two of them, > 0.
};

/// Where a run stands: in memory, and every so often in a file.
class CheckpointKeeper {
 public:
  CheckpointKeeper(CheckpointOptions options, ProblemIdentity problem);

  /// Goes on from there.
  void resume(Checkpoint checkpoint);

  /// The stage in the plane, once it is over.
  const std::optional<Equilibrium>& inPlane() const { return inPlane_; }
  /// The full stage, once inverse design has begun.
  const std::optional<Equilibrium>& full() const { return full_; }
  /// Where the stage that runs stands; nothing when it has only begun.
  const std::optional<SolveCheckpoint>& latest() const { return latest_; }
  /// Where inverse design stands; nothing when it has only begun.
  const std::optional<InverseCheckpoint>& inverse() const { return inverse_; }

  /// Write the file when it is due.
  void keep(SolveCheckpoint solve);
  void keep(InverseCheckpoint inverse);
  /// A solve is over. Writes the file now if it did not converge; nothing more is kept if the run
  /// has to end here.
  void endSolve(const Equilibrium& result);
  /// From here on it is the full stage that is solved.
  void beginFullStage(const Equilibrium& inPlane);
  /// From here on it is inverse design that runs.
  void beginInverseDesign(const Equilibrium& full);
  /// Inverse design is over. Writes the file now if it ended early.
  void endInverseDesign(bool early);

 private:
  using Clock = std::chrono::steady_clock;

  void saveWhenDue();
  void save();

  CheckpointOptions options_;
  ProblemIdentity problem_;
  std::optional<Equilibrium> inPlane_;
  std::optional<Equilibrium> full_;
  std::optional<SolveCheckpoint> latest_;
  std::optional<InverseCheckpoint> inverse_;
  Clock::time_point lastSaved_ = Clock::now();
  bool ended_ = false;
};

}  // namespace morphgrid
