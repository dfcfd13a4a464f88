#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/scene_origin.h"
#include "view/undo_stack.h"

namespace morphgrid {

/// What a user changes of a scene: overrides, as of loadScene(), with undo.
class SceneEdits {
 public:
  using Overrides = std::vector<std::string>;

  SceneEdits(SceneOrigin scene, Overrides overrides)
      : scene_(std::move(scene)), overrides_(std::move(overrides)) {}

  const SceneOrigin& scene() const { return scene_; }
  /// The same overrides of another version of the scene.
  void setScene(SceneOrigin scene) { scene_ = std::move(scene); }
  const Overrides& overrides() const { return overrides_.present(); }

  /// value: as in the scene file.
  void set(const std::string& key, const std::string& value);
  bool canUndo() const { return overrides_.canUndo(); }
  bool canRedo() const { return overrides_.canRedo(); }
  /// Nothing where there is nothing to undo.
  void undo();
  void redo();

  /// Writes a scene file with the overrides in it beside the scene's, because paths start there, or
  /// beside the state that holds it: NAME_edited.toml, or with a number where that is taken; the
  /// next time it is written again. Returns its path. Throws InputError when the scene cannot be
  /// read or the file not be written.
  std::filesystem::path save();

 private:
  SceneOrigin scene_;
  UndoStack<Overrides> overrides_;
  std::filesystem::path saved_;  ///< Empty: not yet.
};

}  // namespace morphgrid
