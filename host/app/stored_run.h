#pragma once
#include "app/restored_run.h"
#include "app/scene_origin.h"
#include "core/file_watch.h"

namespace morphgrid {

/// A finished run, as its state has it, and the scene that it came from.
class StoredRun {
 public:
  /// state: the file. Throws InputError when it, or what its scene names, cannot be read.
  explicit StoredRun(std::filesystem::path state);

  const RestoredRun& run() const { return *run_; }
  /// The scene, as it was when the run began.
  SceneOrigin origin() const;

  /// Reads the state again where it has changed on disk; false where it has not. Throws as the
  /// constructor does, and then keeps what it has.
  bool refresh();

  /// Whether its result is that of the scene with these overrides: none, and the target's files are
  /// as they were when the state was read.
  bool isOf(const std::vector<std::string>& overrides) const;

 private:
  void read();

  std::filesystem::path state_;
  FileWatch stateWatch_;
  FileWatch targetWatch_;
  std::shared_ptr<const RestoredRun> run_;
};

}  // namespace morphgrid
