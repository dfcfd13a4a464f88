#pragma once
#include <gtest/gtest.h>

#include <atomic>

#include "app/live_run.h"
#include "tests/app/scene_files.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {

inline constexpr const char* kVault = R"(
title = "Vault"
[surface]
kind = "bezier"
patch = "patch.toml"
[grid]
layers = 3
layer_spacing = 0.1
nodes_long = 6
)";

/// A live session without a window, under the validation layers.
class LiveSession : public testing::Test {
 protected:
  using Condition = std::function<bool(const Snapshot&)>;

  void start(const std::string& scene, const std::vector<std::string>& overrides = {}) {
    scene_ = folder_.write("scene.toml", scene);
    open(overrides);
  }
  void open(const std::vector<std::string>& overrides = {}) {
    run({.scene = sceneFile(scene_), .overrides = overrides});
  }
  /// A finished run, by its state.
  void openStored(const std::filesystem::path& state,
                  const std::vector<std::string>& overrides = {}) {
    StoredRun stored(state);
    run({.scene = stored.origin(), .overrides = overrides, .stored = std::move(stored)});
  }
  void run(LiveRunOptions options) {
    options.outputFolder = folder_ / "exported";
    options.wake = [this] {
      const LiveRun* live = live_;
      if (live && onPost_) onPost_(live->snapshot());
      wakes_.notify_all();
    };
    live_ = nullptr;
    session_.reset();
    runs_ = 0;
    session_ = std::make_unique<LiveRun>(device_, std::move(options));
    live_ = session_.get();
    session_->showEveryStep(false);
  }
  void TearDown() override {
    session_.reset();
    for (const std::string& message : device_->validationMessages()) {
      ADD_FAILURE() << message;
    }
  }

  /// The first snapshot for which the condition holds; the last one when none comes.
  std::shared_ptr<const Snapshot> await(const Condition& condition) {
    std::unique_lock lock(mutex_);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    auto snapshot = session_->snapshot();
    while (!condition(*snapshot) && std::chrono::steady_clock::now() < end) {
      wakes_.wait_for(lock, std::chrono::milliseconds(5));
      snapshot = session_->snapshot();
    }
    EXPECT_TRUE(condition(*snapshot)) << snapshot->status << snapshot->problem.value_or("");
    return snapshot;
  }
  std::shared_ptr<const Snapshot> awaitActivity(Activity activity) {
    return await([&](const Snapshot& s) { return s.activity == activity; });
  }
  /// At rest after another design than the last one that was awaited.
  std::shared_ptr<const Snapshot> awaitRest() {
    auto snapshot =
        await([&](const Snapshot& s) { return s.activity == Activity::atRest && s.runs > runs_; });
    runs_ = snapshot->runs;
    return snapshot;
  }
  std::shared_ptr<const Snapshot> awaitMessage(const std::string& start) {
    return await([&](const Snapshot& s) { return s.message.rfind(start, 0) == 0; });
  }
  double knob(const std::string& key) const {
    for (const Knob& knob : session_->snapshot()->knobs) {
      if (knob.key == key) return knob.value;
    }
    ADD_FAILURE() << key;
    return 0;
  }
  /// Changes a file so that its time tells.
  void rewrite(const std::string& name, const std::string& text) {
    const auto file = folder_ / name;
    const auto before = std::filesystem::last_write_time(file);
    folder_.write(name, text);
    std::filesystem::last_write_time(file, before + std::chrono::seconds(1));
  }

  TemporaryFolder folder_;
  std::shared_ptr<Device> device_ =
      std::make_shared<Device>(DeviceOptions{.selection = "", .validation = true});
  std::filesystem::path scene_;
  std::mutex mutex_;
  std::condition_variable wakes_;
  long runs_ = 0;
  /// Told of each snapshot by the thread that has posted it; set before the session begins.
  std::function<void(std::shared_ptr<const Snapshot>)> onPost_;
  std::atomic<const LiveRun*> live_ = nullptr;
  std::unique_ptr<LiveRun> session_;
};

/// 3 x vertexCount, as frames draw them.
inline Eigen::Matrix3Xd drawnPositions(const Snapshot& snapshot, ShownStage stage) {
  const DeviceGrid& grid = *snapshot.stages[static_cast<std::size_t>(stage)]->onDevice;
  return grid.downloadPositions(grid.positions());
}

/// What is drawn of a stage; it must be there.
inline const ShownGrid& shownOf(const Snapshot& snapshot, ShownStage stage) {
  return snapshot.stages[static_cast<std::size_t>(stage)].value();
}

}  // namespace morphgrid
