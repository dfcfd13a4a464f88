#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "app/problem_identity.h"
#include "inverse/inverse_checkpoint.h"
#include "solve/equilibrium.h"

namespace morphgrid {

/// A run that can go on later, in another process: what it belongs to, and where it stands.
struct Checkpoint {
  ProblemIdentity problem;
  std::optional<Equilibrium> inPlane;        ///< Once the stage in the plane is over.
  std::optional<Equilibrium> full;           ///< Once inverse design has begun.
  std::optional<SolveCheckpoint> solve;      ///< Where the stage stands that is not over.
  std::optional<InverseCheckpoint> inverse;  ///< Where inverse design stands.
};

/// Throws InputError when the disk refuses.
void writeCheckpoint(const std::filesystem::path& file, const Checkpoint& checkpoint);

/// Throws InputError when the file cannot be read, is no checkpoint, of another version or damaged.
Checkpoint readCheckpoint(const std::filesystem::path& file);

/// Throws InputError when the problems differ; it lists what differs.
void requireSameProblem(const std::filesystem::path& file, const Checkpoint& checkpoint,
                        const ProblemIdentity& problem);

/// Throws InputError when no checkpoint can be written there, or the file is something else.
void requireWritableCheckpoint(const std::filesystem::path& file);

}  // namespace morphgrid
