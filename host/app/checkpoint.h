#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "app/scene.h"
#include "solve/equilibrium.h"

namespace morphgrid {

/// A run that can go on later, in another process: what it belongs to, and where it stands.
struct Checkpoint {
  std::map<std::string, std::string> settings;  ///< As checkpointSettings() gives them.
  std::optional<Equilibrium> inPlane;           ///< Once the stage in the plane is over.
  SolveCheckpoint solve;                        ///< Of the stage that is not.
};

/// What a checkpoint and the run that goes on from it must have in common, by names for people.
/// Tolerances and limits are not among it: they may change on the way.
std::map<std::string, std::string> checkpointSettings(const Scene& scene, const GridDesign& design);

/// In this machine's byte order. Throws InputError when the disk refuses.
void writeCheckpoint(const std::filesystem::path& file, const Checkpoint& checkpoint);

/// Throws InputError when the file cannot be read, is none of ours, of another version or damaged.
Checkpoint readCheckpoint(const std::filesystem::path& file);

/// Throws InputError that lists what differs, if anything does.
void requireSameSettings(const std::filesystem::path& file, const Checkpoint& checkpoint,
                         const std::map<std::string, std::string>& settings);

/// Throws InputError when no checkpoint can be written there, or the file is something else.
void requireWritableCheckpoint(const std::filesystem::path& file);

}  // namespace morphgrid
