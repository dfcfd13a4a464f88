#pragma once
#include <condition_variable>
#include <thread>

#include "app/run_display.h"
#include "app/scene_edits.h"
#include "app/step_gate.h"
#include "app/stored_run.h"
#include "core/file_watch.h"

namespace morphgrid {

struct LiveRunOptions {
  SceneOrigin scene;
  std::vector<std::string> overrides;  ///< See loadScene().
  std::filesystem::path outputFolder;  ///< Where exported files go.
  std::function<void()> wake;          ///< Called from the worker when there is something new.
  TargetKeeper targets;                ///< May hold the scene's target already.
  /// The finished run that the scene is of: what it has come to is shown, not solved again.
  std::optional<StoredRun> stored;
};

/// Does what runScene() does, on a thread of its own, over and over as knobs are turned, and shows
/// how it goes.
class LiveRun final : public Session {
 public:
  LiveRun(std::shared_ptr<Device> device, LiveRunOptions options);
  /// Cancels the run and waits for it.
  ~LiveRun() override;

  std::shared_ptr<const Snapshot> snapshot() const override { return board_.newest(); }
  void noteFrame() override { gate_.noteFrame(); }
  void pause(bool isPaused) override { gate_.pause(isPaused); }
  void step() override { gate_.step(); }
  void showEveryStep(bool isShown) override { gate_.showEveryStep(isShown); }
  void restart() override { demand(Start::flat); }
  void turnKnob(const std::string& key, const std::string& value) override;
  void undo() override;
  void redo() override;
  void reload() override { demand(Start::reloaded); }
  void saveScene() override;
  void exportFiles() override;

 private:
  using Overrides = SceneEdits::Overrides;
  enum class Start {
    flat,
    near,      ///< The last result, where it fits.
    reloaded,  ///< The stored run, where there is one; flat otherwise.
  };

  // Called by any thread.
  void demand(Start start);
  void tell(const std::string& message);
  bool isCancelled() const;
  bool isEnding() const;

  // Called by the worker alone.
  void work();
  bool awaitDemand();
  void workOnce();
  void attemptRun(const Overrides& overrides, Start start);
  void run(const Overrides& overrides, Start start);
  void readStateAgain();
  void showStored();
  /// From now on runs may start where this one has come to rest.
  void startNear(const Simulation& simulation);
  void makeRoom(const Scene& scene, const GridDesign& design);
  void simulate(Scene scene, const SceneDesign& designed, Start start);
  void watchSources(const Overrides& overrides);
  void noteChangedSources();
  void writeFiles();

  std::shared_ptr<Device> device_;
  LiveRunOptions options_;
  SnapshotBoard board_;
  StepGate gate_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  SceneEdits edits_;
  std::optional<Start> demand_ = Start::near;
  bool wantsFiles_ = false;
  bool isEnding_ = false;

  // The worker's own.
  RunDisplay display_;
  std::vector<std::filesystem::path> sources_;
  FileWatch watch_;
  DesignKeeper designs_;
  SolverKeeper solvers_;
  bool solversDoInverseDesign_ = false;
  Eigen::Matrix3Xd lastInPlane_, lastFull_;
  std::optional<Simulation> result_;
  std::optional<Eigen::Matrix3Xd> targets_;  ///< Of the result.
  FileChoices files_;

  std::thread worker_;  ///< Last: it uses all of the above.
};

}  // namespace morphgrid
