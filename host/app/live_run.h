#pragma once
#include <condition_variable>
#include <mutex>
#include <thread>

#include "app/simulate_scene.h"
#include "view/session.h"
#include "view/undo_stack.h"

namespace morphgrid {

struct LiveRunOptions {
  std::filesystem::path scene;
  std::vector<std::string> overrides;  ///< As of loadScene().
  std::filesystem::path outputFolder;  ///< Of exported files.
  std::function<void()> wake;          ///< Called from the worker when there is something new.
};

/// Does what runScene() does, on a thread of its own, over and over as knobs are turned, and shows
/// how it goes.
class LiveRun final : public Session {
 public:
  LiveRun(std::shared_ptr<Device> device, LiveRunOptions options);
  /// Cancels the run and waits for it.
  ~LiveRun() override;

  std::shared_ptr<const Snapshot> snapshot() const override;
  void noteFrame() override;
  void pause(bool isPaused) override;
  void step() override;
  void showEveryStep(bool isShown) override;
  void restart() override;
  void turnKnob(const std::string& key, const std::string& value) override;
  void undo() override;
  void redo() override;
  void reload() override;
  void saveScene() override;
  void exportFiles() override;

 private:
  using Overrides = std::vector<std::string>;
  enum class Start { flat, near };

  // By any thread.
  template <typename Change>
  void publish(const Change& change);
  void demand(Start start);
  void tell(const std::string& message);

  // By the worker.
  void work();
  bool awaitDemand();
  void noteFileTime();
  void run(const Overrides& overrides, Start start);
  void design(const Scene& scene, const SceneDesign& designed);
  void simulate(Scene scene, const SceneDesign& designed, Start start);
  void finish(Simulation simulation);
  void showPrepared(const Stage& stage);
  void showSample(const ConvergenceSample& sample);
  void awaitLeave();
  bool isCancelled() const;
  void writeFiles();

  std::shared_ptr<Device> device_;
  LiveRunOptions options_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::shared_ptr<const Snapshot> snapshot_ = std::make_shared<Snapshot>();
  UndoStack<Overrides> overrides_;
  std::optional<Start> demand_ = Start::flat;
  bool isEnding_ = false;
  bool isPaused_ = false;
  bool wantsFiles_ = false;
  bool showsEveryStep_ = true;
  long leaves_ = 0;  ///< Steps that were asked for one by one.
  long frames_ = 0;

  // The worker's own.
  std::filesystem::file_time_type fileTime_;
  int preparedStages_ = 0;
  ShownGrid live_;  ///< What is solved.
  std::shared_ptr<const Eigen::Matrix3Xd>
      reference_;  ///< Of its middle layer: where it should lie.
  GridShape referenceShape_{};
  bool hasPositions_ = true;  ///< Whether the device's positions are those of the solve.
  Eigen::Matrix3Xd lastInPlane_, lastFull_;
  std::optional<Simulation> result_;
  FileChoices files_;

  std::thread worker_;  ///< Last: it uses all of the above.
};

}  // namespace morphgrid
