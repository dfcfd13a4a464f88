#include "app/stored_run.h"

namespace morphgrid {
namespace {

SceneOrigin originOf(const Scene& scene) { return {scene.file, scene.name, scene.text}; }

}  // namespace

StoredRun::StoredRun(std::filesystem::path state) : state_(std::move(state)) { read(); }

void StoredRun::read() {
  const FileWatch stateWatch({state_});  // As it was before it is read.
  auto run = std::make_shared<const RestoredRun>(restoreRun(state_));
  std::vector<std::filesystem::path> files = listSceneSources(originOf(run->scene), {});
  std::erase(files, state_);
  targetWatch_ = FileWatch(files);
  stateWatch_ = stateWatch;
  run_ = std::move(run);
}

SceneOrigin StoredRun::origin() const { return originOf(run_->scene); }

bool StoredRun::refresh() {
  if (!stateWatch_.hasChanged()) {
    return false;
  }
  read();
  return true;
}

bool StoredRun::isOf(const std::vector<std::string>& overrides) const {
  return overrides.empty() && !targetWatch_.hasChanged();
}

}  // namespace morphgrid
