#include "app/scene_edits.h"

#include <fmt/format.h>

#include <chrono>
#include <sstream>

#include "core/atomic_file.h"
#include "core/toml_document.h"

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
std::filesystem::path freeFileBeside(const std::filesystem::path& scene) {
  const std::string stem = scene.stem().string() + "_edited";
  std::filesystem::path file = scene.parent_path() / (stem + ".toml");
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
  std::ostringstream text;
  text << parseTomlAlone(scene_, overrides_.present()) << '\n';
  if (saved_.empty()) {
    saved_ = freeFileBeside(scene_);
  }
  writeFileAtomically(saved_, text.str());
  return saved_;
}

}  // namespace morphgrid
