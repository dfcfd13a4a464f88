#include "app/live_run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <new>

#include "app/device_capacity.h"
#include "app/pipeline.h"
#include "app/scene_knobs.h"
#include "core/error.h"

namespace morphgrid {
namespace {

constexpr std::chrono::milliseconds kFilePatience(500);

void requireRoom(const Device& device, const Scene& scene, const GridShape& shape) {
  if (const auto reason = explainOverflow(shape, workloadOf(scene), capacityOf(device))) {
    throw InputError(fmt::format("{}: {}", scene.file.string(), *reason));
  }
}

}  // namespace

LiveRun::LiveRun(std::shared_ptr<Device> device, LiveRunOptions options)
    : device_(std::move(device)),
      options_(std::move(options)),
      board_(options_.wake),
      edits_(options_.scene, options_.overrides),
      display_(*device_, board_),
      sources_{options_.scene.file} {
  if (options_.stored) {
    startNear(options_.stored->run().simulation);
  }
  worker_ = std::thread([this] { work(); });
}

LiveRun::~LiveRun() {
  {
    const std::lock_guard lock(mutex_);
    isEnding_ = true;
  }
  changed_.notify_all();
  gate_.wake();
  worker_.join();
}

void LiveRun::tell(const std::string& message) {
  board_.post([&](Snapshot& next) { next.message = message; });
}

/// Whatever is under way is cancelled for it.
void LiveRun::demand(Start start) {
  {
    const std::lock_guard lock(mutex_);
    demand_ = start;
  }
  board_.post([&](Snapshot& next) {
    next.canUndo = edits_.canUndo();
    next.canRedo = edits_.canRedo();
    next.message.clear();
  });
  changed_.notify_all();
  gate_.wake();
}

void LiveRun::turnKnob(const std::string& key, const std::string& value) {
  {
    const std::lock_guard lock(mutex_);
    edits_.set(key, value);
  }
  board_.post([&](Snapshot& next) {
    for (Knob& knob : next.knobs) {
      if (knob.key == key) {
        knob = turned(std::move(knob), value);
      }
    }
  });
  demand(Start::near);
}

void LiveRun::undo() {
  {
    const std::lock_guard lock(mutex_);
    edits_.undo();
  }
  demand(Start::near);
}

void LiveRun::redo() {
  {
    const std::lock_guard lock(mutex_);
    edits_.redo();
  }
  demand(Start::near);
}

void LiveRun::saveScene() {
  try {
    const std::lock_guard lock(mutex_);
    tell(fmt::format("scene saved: {}", edits_.save().string()));
  } catch (const InputError& error) {
    tell(error.what());
  }
}

void LiveRun::exportFiles() {
  {
    const std::lock_guard lock(mutex_);
    wantsFiles_ = true;
  }
  changed_.notify_all();
}

bool LiveRun::isCancelled() const {
  const std::lock_guard lock(mutex_);
  return demand_ || isEnding_;
}

bool LiveRun::isEnding() const {
  const std::lock_guard lock(mutex_);
  return isEnding_;
}

void LiveRun::work() {
  while (awaitDemand()) {
    workOnce();
  }
}

/// False when the session ends.
bool LiveRun::awaitDemand() {
  std::unique_lock lock(mutex_);
  while (!demand_ && !wantsFiles_ && !isEnding_) {
    changed_.wait_for(lock, kFilePatience);
    lock.unlock();
    noteChangedSources();
    lock.lock();
  }
  return !isEnding_;
}

void LiveRun::workOnce() {
  std::unique_lock lock(mutex_);
  if (!demand_) {
    wantsFiles_ = false;
    lock.unlock();
    return writeFiles();
  }
  const Start start = *demand_;
  const Overrides overrides = edits_.overrides();
  demand_.reset();
  lock.unlock();
  attemptRun(overrides, start);
}

void LiveRun::attemptRun(const Overrides& overrides, Start start) {
  try {
    run(overrides, start);
  } catch (const Cancelled&) {
  } catch (const std::bad_alloc&) {
    solvers_.clear();
    display_.showFailure("out of memory: ask for fewer nodes");
  } catch (const std::exception& error) {
    solvers_.clear();  // They may have been left in the middle of something.
    display_.showFailure(error.what());
  }
}

void LiveRun::run(const Overrides& overrides, Start start) {
  result_.reset();
  readStateAgain();
  watchSources(overrides);
  if (start != Start::flat && options_.stored && options_.stored->isOf(overrides)) {
    return showStored();
  }
  display_.showBegin("designing");
  Scene scene = loadScene(options_.scene, overrides);
  scene.solve.isCancelled = [this] { return isCancelled(); };
  files_ = scene.files;
  display_.showScene(scene);
  // Turning knobs meanwhile does not end it: they leave the target as it is.
  const Cancellation ending([this] { return isEnding(); });
  const auto designed = designs_.designOf(scene, options_.targets.targetOf(scene, ending));
  makeRoom(scene, designed->design);
  display_.showDesign(scene, *designed);
  simulate(std::move(scene), *designed, start);
}

void LiveRun::readStateAgain() {
  if (options_.stored && options_.stored->refresh()) {
    options_.scene = options_.stored->origin();
    const std::lock_guard lock(mutex_);
    edits_.setScene(options_.scene);
  }
}

void LiveRun::showStored() {
  const RestoredRun& run = options_.stored->run();
  display_.showBegin("opening");
  files_ = run.scene.files;
  display_.showStored(run);
  startNear(run.simulation);
  result_ = run.simulation;
  targets_ = run.designed.targets;
}

void LiveRun::startNear(const Simulation& simulation) {
  lastInPlane_ = simulation.record.inPlane->positions;
  lastFull_ = simulation.stage.equilibrium.positions;
}

/// Keeps the solvers that serve the scene too.
void LiveRun::makeRoom(const Scene& scene, const GridDesign& design) {
  const GridShape shape{design.nodesU + 1, design.nodesV + 1, design.layers};
  const bool doesInverseDesign = workloadOf(scene).inverseDesign;
  if (scene.method != Method::multigrid ||
      !solvers_.has(shape, mechanicsOf(scene.material.model)) ||
      doesInverseDesign > solversDoInverseDesign_) {
    solvers_.clear();
    requireRoom(*device_, scene, shape);
    solversDoInverseDesign_ = doesInverseDesign;
  }
}

void LiveRun::simulate(Scene scene, const SceneDesign& designed, Start start) {
  const Cancellation cancellation(scene.solve.isCancelled);
  scene.smallestEigenvalue = false;
  scene.solve.onPositions = [this](const auto& positions) { display_.showPositions(positions); };
  scene.solve.onGrid = [this](const auto& coarse) { display_.showGrid(coarse); };
  scene.solve.onProgress = [this, isCancelled = scene.solve.isCancelled](const auto& sample) {
    display_.showSample(sample);
    noteChangedSources();
    gate_.pass(isCancelled, [this] {
      display_.showPaused();
      noteChangedSources();
    });
  };
  RunContext context;
  context.device = device_;
  context.solvers = &solvers_;
  context.onCheckFromFlat = [this](const auto& chosen) { display_.showCheckFromFlat(chosen); };
  context.onStage = [&](const Stage& stage) {
    cancellation.check();
    if (!stage.onDevice) {
      throw DeviceError(context.failure.value_or("the device does not hold the grid"));
    }
    display_.showStage(stage);
  };
  if (start == Start::near) {
    context.nearInPlane = lastInPlane_;
    context.nearFull = lastFull_;
  }
  CheckpointKeeper keeper({}, {});
  Simulation simulation = simulateScene(scene, designed, context, keeper, true);
  if (context.failure) {
    throw DeviceError(*context.failure);
  }
  cancellation.check();
  startNear(simulation);
  display_.showEnd(simulation);
  result_ = std::move(simulation);
  targets_ = designed.targets;
}

/// What loadScene() is about to read. Where that fails, the files of before are still of interest.
void LiveRun::watchSources(const Overrides& overrides) {
  try {
    sources_ = listSceneSources(options_.scene, overrides);
  } catch (const InputError&) {  // loadScene() will tell.
  }
  watch_ = FileWatch(sources_);
}

void LiveRun::noteChangedSources() {
  if (!board_.newest()->isOutdated && watch_.hasChanged()) {
    board_.post([](Snapshot& next) { next.isOutdated = true; });
  }
}

void LiveRun::writeFiles() {
  if (!result_) {
    tell("there is no result to export yet");
    return;
  }
  try {
    std::filesystem::create_directories(options_.outputFolder);
    OutputFiles files(options_.outputFolder, true);
    morphgrid::exportFiles(*result_, targets_, files_, files);
    tell(files.lost().empty() ? fmt::format("files exported to {}", options_.outputFolder.string())
                              : fmt::format("{}", fmt::join(files.lost(), "\n")));
  } catch (const std::exception& error) {
    tell(error.what());
  }
}

}  // namespace morphgrid
