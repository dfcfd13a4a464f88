#include "app/live_run.h"

#include <fmt/format.h>

#include <chrono>
#include <sstream>

#include "app/pipeline.h"
#include "app/scene_knobs.h"
#include "app/solve_room.h"
#include "core/atomic_file.h"
#include "core/rigid_alignment.h"
#include "core/toml_document.h"
#include "report/report_files.h"

namespace morphgrid {
namespace {

using Clock = std::chrono::steady_clock;

// A window that shows no frames, minimised or closing, must not stop the solver.
constexpr std::chrono::milliseconds kFramePatience(100);
constexpr std::chrono::milliseconds kFilePatience(500);

std::size_t placeOf(ShownStage stage) { return static_cast<std::size_t>(stage); }

/// The override of this key replaced, or a new one.
std::vector<std::string> withOverride(std::vector<std::string> overrides, const std::string& key,
                                      const std::string& value) {
  std::erase_if(overrides,
                [&](const std::string& assignment) { return assignment.rfind(key + "=", 0) == 0; });
  overrides.push_back(key + "=" + value);
  return overrides;
}

/// Of a layer's points, those that are nearest to the vertices of another layer on the same sheet.
Eigen::Matrix3Xd resampled(const Eigen::Matrix3Xd& points, const GridShape& from,
                           const GridShape& to) {
  Eigen::Matrix3Xd result(3, to.layerVertexCount());
  const auto nearest = [](int n, int count, int fromCount) {
    return static_cast<int>(std::lround(double(n) * (fromCount - 1) / (count - 1)));
  };
  for (int j = 0; j < to.verticesV; ++j) {
    for (int i = 0; i < to.verticesU; ++i) {
      result.col(to.index(i, j, 0)) = points.col(from.index(
          nearest(i, to.verticesU, from.verticesU), nearest(j, to.verticesV, from.verticesV), 0));
    }
  }
  return result;
}

double rmsPercent(const Eigen::Matrix3Xd& placed, const Eigen::Matrix3Xd& targets) {
  const double diagonal = (targets.rowwise().maxCoeff() - targets.rowwise().minCoeff()).norm();
  return 100 * (placed - targets).norm() / std::sqrt(double(targets.cols())) / diagonal;
}

const Buffer& newestPositions(const DeviceGrid& grid) {
  return grid.newestIsFirst() ? grid.positions() : grid.previousPositions();
}

}  // namespace

LiveRun::LiveRun(std::shared_ptr<Device> device, LiveRunOptions options)
    : device_(std::move(device)),
      options_(std::move(options)),
      overrides_(options_.overrides),
      worker_([this] { work(); }) {}

LiveRun::~LiveRun() {
  {
    const std::lock_guard lock(mutex_);
    isEnding_ = true;
  }
  changed_.notify_all();
  worker_.join();
}

template <typename Change>
void LiveRun::publish(const Change& change) {
  {
    const std::lock_guard lock(mutex_);
    auto next = std::make_shared<Snapshot>(*snapshot_);
    change(*next);
    snapshot_ = std::move(next);
  }
  options_.wake();
}

std::shared_ptr<const Snapshot> LiveRun::snapshot() const {
  const std::lock_guard lock(mutex_);
  return snapshot_;
}

void LiveRun::tell(const std::string& message) {
  publish([&](Snapshot& next) { next.message = message; });
}

void LiveRun::noteFrame() {
  {
    const std::lock_guard lock(mutex_);
    ++frames_;
  }
  changed_.notify_all();
}

void LiveRun::pause(bool isPaused) {
  {
    const std::lock_guard lock(mutex_);
    isPaused_ = isPaused;
  }
  changed_.notify_all();
}

void LiveRun::step() {
  {
    const std::lock_guard lock(mutex_);
    isPaused_ = true;
    ++leaves_;
  }
  changed_.notify_all();
}

void LiveRun::showEveryStep(bool isShown) {
  const std::lock_guard lock(mutex_);
  showsEveryStep_ = isShown;
}

/// Whatever is under way is cancelled for it.
void LiveRun::demand(Start start) {
  {
    const std::lock_guard lock(mutex_);
    demand_ = start;
  }
  publish([&](Snapshot& next) {
    next.canUndo = overrides_.canUndo();
    next.canRedo = overrides_.canRedo();
    next.message.clear();
  });
  changed_.notify_all();
}

void LiveRun::restart() { demand(Start::flat); }

void LiveRun::turnKnob(const std::string& key, const std::string& value) {
  const double now = std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
  {
    const std::lock_guard lock(mutex_);
    overrides_.change(withOverride(overrides_.present(), key, value), key, now);
  }
  publish([&](Snapshot& next) {
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
    overrides_.undo();
  }
  demand(Start::near);
}

void LiveRun::redo() {
  {
    const std::lock_guard lock(mutex_);
    overrides_.redo();
  }
  demand(Start::near);
}

void LiveRun::reload() { demand(Start::flat); }

void LiveRun::saveScene() {
  // Beside the scene: its paths start there.
  const std::filesystem::path file =
      options_.scene.parent_path() / (options_.scene.stem().string() + "_edited.toml");
  try {
    std::ostringstream text;
    text << parseToml(options_.scene, overrides_.present()) << '\n';
    writeFileAtomically(file, text.str());
    tell(fmt::format("scene saved: {}", file.string()));
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

void LiveRun::work() {
  while (awaitDemand()) {
    std::unique_lock lock(mutex_);
    if (!demand_) {
      wantsFiles_ = false;
      lock.unlock();
      writeFiles();
      continue;
    }
    const Start start = *demand_;
    const Overrides overrides = overrides_.present();
    demand_.reset();
    lock.unlock();
    try {
      run(overrides, start);
    } catch (const Cancelled&) {
    } catch (const std::exception& error) {
      publish([&](Snapshot& next) {
        next.activity = Activity::failed;
        next.status = "failed";
        next.problem = error.what();
      });
    }
  }
}

/// False when the session ends.
bool LiveRun::awaitDemand() {
  std::unique_lock lock(mutex_);
  while (!demand_ && !wantsFiles_ && !isEnding_) {
    changed_.wait_for(lock, kFilePatience);
    lock.unlock();
    noteFileTime();
    lock.lock();
  }
  return !isEnding_;
}

void LiveRun::noteFileTime() {
  std::error_code error;
  const auto time = std::filesystem::last_write_time(options_.scene, error);
  if (!error && time != fileTime_ && !snapshot()->isOutdated) {
    publish([](Snapshot& next) { next.isOutdated = true; });
  }
}

bool LiveRun::isCancelled() const {
  const std::lock_guard lock(mutex_);
  return demand_ || isEnding_;
}

void LiveRun::run(const Overrides& overrides, Start start) {
  result_.reset();
  publish([](Snapshot& next) {
    next.activity = Activity::designing;
    next.status = "designing";
    next.problem.reset();
    next.isOutdated = false;
  });
  std::error_code error;
  fileTime_ = std::filesystem::last_write_time(options_.scene, error);
  Scene scene = loadScene(options_.scene, overrides);
  files_ = scene.files;
  scene.solve.isCancelled = [this] { return isCancelled(); };
  const SceneDesign designed = designScene(scene);
  design(scene, designed);
  if (!isCancelled()) {
    simulate(std::move(scene), designed, start);
  }
}

/// Shows what the design says, and the target.
void LiveRun::design(const Scene& scene, const SceneDesign& designed) {
  const RunRecord record = recordOf(scene, designed);
  const GridShape& shape = record.grid.shape;
  if (const auto reason = whyTooLarge(shape, scene.method, roomOn(*device_))) {
    throw InputError(fmt::format("{}: {}", scene.file.string(), *reason));
  }
  std::optional<ShownGrid> target;
  if (designed.targets) {
    target.emplace();
    target->grid =
        std::make_shared<StrutGrid>(layerAtRest(shape, designed.design.spacing, *designed.targets));
    target->onDevice = std::make_shared<DeviceGrid>(*device_, *target->grid);
    target->positions = std::make_shared<Eigen::Matrix3Xd>(*designed.targets);
    reference_ = target->positions;
    referenceShape_ = {shape.verticesU, shape.verticesV, 1};
  } else {
    reference_.reset();
  }
  std::shared_ptr<const ShownSampling> sampling;
  if (designed.sampling) {
    sampling =
        std::make_shared<ShownSampling>(ShownSampling{scene.mesh->mesh, designed.sampling->hits});
  }
  publish([&](Snapshot& next) {
    next.title = scene.title;
    next.stages = {};
    next.sampling = sampling;
    next.stages[placeOf(ShownStage::target)] = target;
    next.newest = ShownStage::target;
    next.targets = designed.targets ? target->positions : nullptr;
    next.view = scene.mesh ? kMeshView : kPatchView;
    next.maxShrinkage = scene.design.maxShrinkage;
    next.knobs = keepRanges(knobsOf(scene), next.knobs);
    next.figures = toTable(record);
    next.notices = record.notices;
    next.extent.setEmpty();
    if (designed.targets) {
      next.extent.extend(designed.targets->rowwise().minCoeff());
      next.extent.extend(designed.targets->rowwise().maxCoeff());
    }
    next.strutCount = shape.strutCount();
    ++next.runs;
  });
}

void LiveRun::simulate(Scene scene, const SceneDesign& designed, Start start) {
  scene.smallestEigenvalue = false;
  scene.solve.onProgress = [this](const ConvergenceSample& sample) { showSample(sample); };
  scene.solve.onGrid = [this](std::shared_ptr<const DeviceGrid> coarse) {
    publish([&](Snapshot& next) {
      ShownGrid& shown = *next.stages[placeOf(next.newest)];
      shown.onDevice = coarse ? coarse : live_.onDevice;
      shown.grid = coarse ? nullptr : live_.grid;
      shown.positions = coarse ? nullptr : live_.positions;
    });
  };
  hasPositions_ = scene.method != Method::reference;
  preparedStages_ = 0;
  Stagehands hands;
  hands.device = device_;
  hands.onStage = [this](const Stage& stage) { showPrepared(stage); };
  if (start == Start::near) {
    hands.nearInPlane = lastInPlane_;
    hands.nearFull = lastFull_;
  }
  CheckpointKeeper keeper({}, {});
  Simulation simulation = simulateScene(scene, designed, hands, keeper, true);
  if (hands.failure) {
    throw DeviceError(*hands.failure);
  }
  if (!isCancelled()) {
    finish(std::move(simulation));
  }
}

void LiveRun::finish(Simulation simulation) {
  const Stage& stage = simulation.stage;
  const RunRecord& record = simulation.record;
  const Equilibrium& last = stage.equilibrium;
  lastInPlane_ = record.inPlane->positions;
  lastFull_ = last.positions;
  live_.grid = std::make_shared<StrutGrid>(stage.grid);  // Inverse design has changed it.
  live_.positions = std::make_shared<Eigen::Matrix3Xd>(last.positions);
  live_.worldFromGrid = simulation.targetFromGrid;
  stage.onDevice->uploadPositions(last.positions);
  publish([&](Snapshot& next) {
    next.activity = Activity::atRest;
    next.status = fmt::format(
        "at rest after {} iterations ({}), {:.2f} s", last.iterations,
        last.converged ? "converged" : "NOT converged: " + toString(last.reason), last.seconds);
    next.stages[placeOf(next.newest)] = live_;
    if (record.full) {
      next.stages[placeOf(ShownStage::surface)] = live_;
    }
    next.figures = toTable(record);
    next.notices = record.notices;
    next.history = last.history;
  });
  result_ = std::move(simulation);
}

/// The first of a run is the one in the plane.
void LiveRun::showPrepared(const Stage& stage) {
  if (isCancelled()) {
    throw Cancelled();
  }
  if (!stage.onDevice) {
    return;
  }
  const bool inPlane = preparedStages_++ == 0;
  const GridShape& shape = stage.grid.shape;
  live_.onDevice = stage.onDevice;
  live_.grid = std::make_shared<StrutGrid>(stage.grid);
  live_.positions = std::make_shared<Eigen::Matrix3Xd>(stage.grid.positions);
  if (!reference_) {  // Without target, it stays where it begins.
    reference_ = std::make_shared<Eigen::Matrix3Xd>(middleLayer(shape, stage.grid.positions));
    referenceShape_ = shape;
  }
  live_.worldFromGrid = alignRigidly(middleLayer(shape, stage.grid.positions), *reference_);
  ShownGrid before = live_;
  before.onDevice = std::make_shared<DeviceGrid>(*device_, stage.grid);
  const Eigen::Matrix3Xd placed = live_.worldFromGrid * stage.grid.positions;
  publish([&](Snapshot& next) {
    next.activity = Activity::solving;
    next.status = inPlane ? "in plane" : "full";
    next.stages[placeOf(inPlane ? ShownStage::initial : ShownStage::stacked)] = before;
    next.newest = inPlane ? ShownStage::inPlane : ShownStage::warped;
    next.stages[placeOf(next.newest)] = live_;
    next.history.clear();
    if (inPlane) {
      next.extent.extend(placed.rowwise().minCoeff());
      next.extent.extend(placed.rowwise().maxCoeff());
    }
  });
}

void LiveRun::showSample(const ConvergenceSample& sample) {
  const auto before = snapshot();
  ShownGrid shown = *before->stages[placeOf(before->newest)];
  std::string status = fmt::format("{}: iteration {}, residual {:.2g}",
                                   before->newest == ShownStage::inPlane ? "in plane" : "full",
                                   sample.iteration, sample.residual);
  if (hasPositions_) {
    const DeviceGrid& grid = *shown.onDevice;
    auto positions =
        std::make_shared<Eigen::Matrix3Xd>(grid.downloadPositions(newestPositions(grid)));
    const Eigen::Matrix3Xd middle = middleLayer(grid.shape(), *positions);
    const Eigen::Matrix3Xd reference = resampled(*reference_, referenceShape_, grid.shape());
    shown.worldFromGrid = alignRigidly(middle, reference);
    if (before->targets && before->newest == ShownStage::warped) {
      status += fmt::format(", distance {:.3g} % RMS",
                            rmsPercent(shown.worldFromGrid * middle, reference));
    }
    if (shown.grid) {
      shown.positions = std::move(positions);
    }
  }
  publish([&](Snapshot& next) {
    next.activity = Activity::solving;
    next.status = status;
    next.stages[placeOf(next.newest)] = shown;
    next.history.push_back(sample);
  });
  awaitLeave();
}

/// Waits while paused, and until the last step has been seen.
void LiveRun::awaitLeave() {
  std::unique_lock lock(mutex_);
  const auto stops = [&] { return demand_ || isEnding_ || interruptRequested(); };
  if (isPaused_ && !stops()) {
    lock.unlock();
    publish([](Snapshot& next) { next.activity = Activity::paused; });
    lock.lock();
    while (isPaused_ && leaves_ == 0 && !stops()) {
      changed_.wait_for(lock, kFramePatience);
    }
    leaves_ = std::max(leaves_ - 1, 0L);
  }
  if (showsEveryStep_) {
    // The frame under way may have begun before this step.
    const long seen = frames_ + 1;
    changed_.wait_for(lock, kFramePatience, [&] { return frames_ > seen || stops(); });
  }
}

void LiveRun::writeFiles() {
  if (!result_) {
    tell("there is no result to export yet");
    return;
  }
  try {
    std::filesystem::create_directories(options_.outputFolder);
    morphgrid::exportFiles(result_->stage, result_->targetFromGrid, files_, options_.outputFolder);
    tell(fmt::format("files exported to {}", options_.outputFolder.string()));
  } catch (const std::exception& error) {
    tell(error.what());
  }
}

}  // namespace morphgrid
