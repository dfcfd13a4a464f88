#include "app/scene_edits.h"

#include <fmt/format.h>

#include <chrono>

#include "core/atomic_file.h"

namespace morphgrid {
namespace {

/// The override of this key replaced, or a new one.
SceneEdits::Overrides withOverride(SceneEdits::Overrides overrides, const std::string& key,
                                   const std::string& value) {
  std::erase_if(overrides,
                [&](const std::string& assignment) { return assignment.rfind(key + "=", 0) == 0; });
  overrides.push_back(key + "=" + value);
  return overrides;
}

/// Where nothing is: what another session or the user has written stays.
std::filesystem::path freeFileBeside(const SceneOrigin& scene) {
  const std::string stem = scene.name + "_edited";
  std::filesystem::path file = scene.file.parent_path() / (stem + ".toml");
  std::error_code ignored;  // Writing reports what is wrong with the folder.
  for (int n = 2; std::filesystem::exists(file, ignored); ++n) {
    file.replace_filename(fmt::format("{}_{}.toml", stem, n));
  }
  return file;
}

}  // namespace

void SceneEdits::set(const std::string& key, const std::string& value) {
  const std::chrono::duration<double> now = std::chrono::steady_clock::now().time_since_epoch();
  overrides_.change(withOverride(overrides_.present(), key, value), key, now.count());
}

void SceneEdits::undo() {
  if (overrides_.canUndo()) {
    overrides_.undo();
  }
}

void SceneEdits::redo() {
  if (overrides_.canRedo()) {
    overrides_.redo();
  }
}

std::filesystem::path SceneEdits::save() {
  const std::string text = editedScene(scene_, overrides_.present());
  if (saved_.empty()) {
    saved_ = freeFileBeside(scene_);
  }
  writeFileAtomically(saved_, text);
  return saved_;
}

}  // namespace morphgrid
