#include "app/run_display.h"

#include <fmt/format.h>

#include <optional>

#include "app/scene_knobs.h"
#include "core/intrinsic_diagonal.h"
#include "core/rigid_alignment.h"
#include "report/judge_run.h"
#include "report/report_table.h"
#include "view/view_state.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;

std::optional<ShownGrid>& slotOf(ShownStage stage, Snapshot& snapshot) {
  return snapshot.stages[static_cast<std::size_t>(stage)];
}

/// For each vertex of the layer `to` the nearest of the points of the layer `from`, by their places
/// on the same sheet.
Matrix3Xd resampled(const Matrix3Xd& points, const GridShape& from, const GridShape& to) {
  Matrix3Xd result(3, to.layerVertexCount());
  const auto nearest = [](int n, int count, int fromCount) {
    return static_cast<int>(std::lround(double(n) * (fromCount - 1) / (count - 1)));
  };
  forEachVertex(to.layer(), [&](const GridPlace& place) {
    result.col(to.index(place)) =
        points.col(from.index(nearest(place.i, to.verticesU, from.verticesU),
                              nearest(place.j, to.verticesV, from.verticesV), 0));
  });
  return result;
}

double rmsPercent(const Matrix3Xd& placed, const Matrix3Xd& targets) {
  const double diagonal = intrinsicDiagonal(targets);
  return 100 * (placed - targets).norm() / std::sqrt(double(targets.cols())) / diagonal;
}

const Buffer& newestOf(const DeviceGrid& grid) {
  return grid.newestIsFirst() ? grid.positions() : grid.previousPositions();
}

/// None where the grid is no frame.
std::shared_ptr<const JointRotations> shared(const JointRotations& rotations) {
  return rotations.cols() > 0 ? std::make_shared<JointRotations>(rotations) : nullptr;
}

double meanRestOf(const GridDesign& design) {
  double sum = 0;
  for (const LateralField<double>& layer : design.rest) {
    forEachLateralStrut(layer.shape(), [&](const Strut& strut) { sum += layer.at(strut); });
  }
  const GridShape& shape = design.rest.front().shape();
  return sum / (static_cast<double>(design.rest.size()) * shape.lateralStrutCount());
}

void extend(Eigen::AlignedBox3d& box, const Matrix3Xd& points) {
  box.extend(points.rowwise().minCoeff());
  box.extend(points.rowwise().maxCoeff());
}

/// It lives as long as its target.
std::shared_ptr<const MeshSampling> samplingOf(const std::shared_ptr<const Target>& target) {
  return target ? std::shared_ptr<const MeshSampling>(target, target->meshSampling()) : nullptr;
}

/// meanLength: of lateral struts, of which a frame's sizes are shares that the scene does not say;
/// 0 where it is not known yet.
void putKnobs(Scene scene, double meanLength, const std::optional<double>& mmPerUnit,
              Snapshot& next) {
  if (scene.material.model == Model::frame && meanLength > 0) {
    scene.material = withSizes(materialOf(scene, mmPerUnit), meanLength);
  }
  next.knobs = keepRanges(knobsOf(scene), next.knobs);
}

void putScene(const Scene& scene, double meanLength, const std::optional<double>& mmPerUnit,
              Snapshot& next) {
  next.title = scene.title;
  putKnobs(scene, meanLength, mmPerUnit, next);
  next.shrinkBounds = shrinkBoundsOf(scene, std::nullopt);
}

/// Nothing but the target is there.
void putDesign(const SceneDesign& designed, const RunRecord& record,
               const std::optional<ShownGrid>& target, Snapshot& next) {
  next.view = designed.view();
  next.stages = {};
  next.sampling = samplingOf(designed.target);
  slotOf(ShownStage::target, next) = target;
  next.newest = ShownStage::target;
  next.targets = target ? target->positions : nullptr;
  next.angleErrors = designed.angleErrors.size() > 0
                         ? std::make_shared<Eigen::VectorXd>(designed.angleErrors)
                         : nullptr;
  next.figures = toTable(record);
  next.notices = textsOf(record.notices);
  next.extent.setEmpty();
  if (target) {
    extend(next.extent, *target->positions);
  }
  next.strutCount = record.grid.shape.strutCount();
  ++next.runs;
}

void putEnd(const Simulation& simulation, const ShownGrid& end, Snapshot& next) {
  const RunRecord& record = simulation.record;
  const Equilibrium& last = simulation.stage.equilibrium;
  next.activity = Activity::atRest;
  next.status = fmt::format(
      "at rest after {} iterations ({}), {:.2f} s", last.iterations,
      last.converged ? "converged" : "NOT converged: " + toString(last.reason), last.seconds);
  slotOf(next.newest, next) = end;
  if (record.full) {
    slotOf(ShownStage::surface, next) = end;
  }
  next.figures = toTable(record) + judgeRun(record).line();
  next.notices = textsOf(record.notices);
  next.history = last.history;
}

}  // namespace

void RunDisplay::showBegin(const std::string& status) {
  stages_ = 0;
  board_.post([&](Snapshot& next) {
    next.activity = Activity::designing;
    next.status = status;
    next.problem.reset();
    next.isOutdated = false;
  });
}

void RunDisplay::showScene(const Scene& scene) {
  board_.post([&](Snapshot& next) { putScene(scene, meanLength_, mmPerUnit_, next); });
}

std::optional<ShownGrid> RunDisplay::makeTarget(const GridShape& shape,
                                                const SceneDesign& designed) {
  reference_.reset();
  if (!designed.targets) {
    return std::nullopt;
  }
  ShownGrid target;
  target.grid =
      std::make_shared<StrutGrid>(layerAtRest(shape, designed.design.spacing, *designed.targets));
  target.onDevice = std::make_shared<DeviceGrid>(device_, *target.grid);
  target.positions = std::make_shared<Matrix3Xd>(*designed.targets);
  reference_ = target.positions;
  referenceShape_ = shape.layer();
  return target;
}

void RunDisplay::showDesign(const Scene& scene, const SceneDesign& designed) {
  const RunRecord record = recordOf(scene, designed);
  const auto target = makeTarget(record.grid.shape, designed);
  meanLength_ = meanRestOf(designed.design);
  mmPerUnit_ = designed.mmPerUnit;
  board_.post([&](Snapshot& next) {
    putDesign(designed, record, target, next);
    putKnobs(scene, meanLength_, mmPerUnit_, next);
  });
}

/// A copy of a grid, its middle layer as close to where it should lie as it comes.
ShownGrid RunDisplay::placed(const StrutGrid& grid, const Matrix3Xd& positions,
                             const JointRotations& rotations) {
  const Matrix3Xd middle = middleLayer(grid.shape, positions);
  if (!reference_) {  // Without target, it stays where it begins.
    reference_ = std::make_shared<Matrix3Xd>(middle);
    referenceShape_ = grid.shape.layer();
  }
  auto onDevice = std::make_shared<DeviceGrid>(device_, grid);
  onDevice->uploadPositions(positions, rotations);
  return {.onDevice = onDevice,
          .worldFromGrid = alignRigidly(middle, *reference_),
          .grid = std::make_shared<StrutGrid>(grid),
          .positions = std::make_shared<Matrix3Xd>(positions),
          .rotations = shared(onDevice->downloadRotations(onDevice->positions()))};
}

void RunDisplay::showStage(const Stage& stage) {
  const bool inPlane = stages_++ == 0;
  const ShownGrid before = placed(stage.grid, stage.grid.positions);
  onDevice_ = stage.onDevice;
  live_ = before;
  live_.onDevice = stage.onDevice->onlooker();
  board_.post([&](Snapshot& next) {
    next.activity = Activity::solving;
    next.status = inPlane ? "in plane" : "full";
    next.shrinkBounds = stage.shrinkBounds;
    slotOf(inPlane ? ShownStage::initial : ShownStage::stacked, next) = before;
    next.newest = inPlane ? ShownStage::inPlane : ShownStage::warped;
    slotOf(next.newest, next) = live_;
    next.history.clear();
    if (inPlane) {
      extend(next.extent, live_.worldFromGrid * stage.grid.positions);
    }
  });
}

void RunDisplay::showGrid(const std::shared_ptr<const DeviceGrid>& coarse) {
  board_.post([&](Snapshot& next) {
    ShownGrid& shown = *slotOf(next.newest, next);
    shown.onDevice = coarse ? coarse : live_.onDevice;
    shown.grid = coarse ? nullptr : live_.grid;
    shown.positions = coarse ? nullptr : live_.positions;
    shown.rotations = coarse ? nullptr : live_.rotations;
  });
}

ShownGrid RunDisplay::withNewestPositions(ShownGrid shown) const {
  const DeviceGrid& grid = *shown.onDevice;
  const GridShape& shape = grid.shape();
  const Buffer& newest = newestOf(grid);
  auto positions = std::make_shared<Matrix3Xd>(grid.downloadPositions(newest));
  shown.worldFromGrid =
      alignRigidly(middleLayer(shape, *positions), resampled(*reference_, referenceShape_, shape));
  shown.positions = std::move(positions);
  shown.rotations = shared(grid.downloadRotations(newest));
  return shown;
}

std::string RunDisplay::describeDistance(const ShownGrid& shown, const Snapshot& snapshot) const {
  if (!snapshot.targets || snapshot.newest != ShownStage::warped) {
    return "";
  }
  const GridShape& shape = shown.onDevice->shape();
  const double rms = rmsPercent(shown.worldFromGrid * middleLayer(shape, *shown.positions),
                                resampled(*reference_, referenceShape_, shape));
  return fmt::format(", distance {:.3g} % RMS", rms);
}

void RunDisplay::showSample(const ConvergenceSample& sample) {
  const auto before = board_.newest();
  ShownGrid shown = *gridOf(before->newest, *before);
  std::string status = fmt::format("{}: iteration {}, residual {:.2g}",
                                   before->newest == ShownStage::inPlane ? "in plane" : "full",
                                   sample.iteration, sample.residual);
  shown = withNewestPositions(std::move(shown));
  status += describeDistance(shown, *before);
  if (!shown.grid) {
    shown.positions = nullptr;
    shown.rotations = nullptr;
  }
  board_.post([&](Snapshot& next) {
    next.activity = Activity::solving;
    next.status = status;
    slotOf(next.newest, next) = shown;
    next.history.push_back(sample);
  });
}

void RunDisplay::showPaused() {
  if (board_.newest()->activity != Activity::paused) {
    board_.post([](Snapshot& next) { next.activity = Activity::paused; });
  }
}

void RunDisplay::showCheckFromFlat(const StrutGrid& chosen) {
  const DeviceGrid& grid = *live_.onDevice;
  const Buffer& newest = newestOf(grid);
  const ShownGrid still =
      placed(chosen, grid.downloadPositions(newest), grid.downloadRotations(newest));
  board_.post([&](Snapshot& next) {
    next.status = "full: checking whether the design gets there from flat";
    slotOf(next.newest, next) = still;
  });
}

void RunDisplay::showEnd(const Simulation& simulation) {
  const Stage& stage = simulation.stage;
  const Matrix3Xd& positions = stage.equilibrium.positions;
  live_.grid = std::make_shared<StrutGrid>(stage.grid);  // Inverse design has changed it.
  live_.positions = std::make_shared<Matrix3Xd>(positions);
  live_.rotations = shared(stage.equilibrium.rotations);
  live_.worldFromGrid = simulation.targetFromGrid;
  stage.onDevice->uploadPositions(positions, stage.equilibrium.rotations);
  std::optional<ShownGrid> printed;
  if (simulation.record.inverse) {
    printed = placed(stage.grid, stage.grid.positions);
  }
  board_.post([&](Snapshot& next) {
    if (printed) slotOf(ShownStage::stacked, next) = *printed;
    putEnd(simulation, live_, next);
  });
}

void RunDisplay::showStored(const RestoredRun& run) {
  const Stage& stage = run.simulation.stage;
  const RunRecord& record = run.simulation.record;
  const auto target = makeTarget(record.grid.shape, run.designed);
  meanLength_ = meanRestOf(run.designed.design);
  mmPerUnit_ = stage.mmPerUnit;
  const ShownGrid initial = placed(run.inPlane, run.inPlane.positions);
  const ShownGrid inPlane = placed(run.inPlane, record.inPlane->positions);
  const ShownGrid stacked = placed(stage.grid, stage.grid.positions);
  ShownGrid end = placed(stage.grid, stage.equilibrium.positions, stage.equilibrium.rotations);
  end.worldFromGrid = run.simulation.targetFromGrid;
  board_.post([&](Snapshot& next) {
    putScene(run.scene, meanLength_, stage.mmPerUnit, next);
    putDesign(run.designed, record, target, next);
    next.shrinkBounds = stage.shrinkBounds;
    if (run.sampling) next.sampling = std::make_shared<MeshSampling>(*run.sampling);
    extend(next.extent, initial.worldFromGrid * run.inPlane.positions);
    slotOf(ShownStage::initial, next) = initial;
    slotOf(ShownStage::inPlane, next) = inPlane;
    next.newest = record.full ? ShownStage::warped : ShownStage::inPlane;
    if (record.full) {
      slotOf(ShownStage::stacked, next) = stacked;
    }
    putEnd(run.simulation, end, next);
    next.status += ", as stored";
  });
}

void RunDisplay::showFailure(const std::string& problem) {
  board_.post([&](Snapshot& next) {
    next.activity = Activity::failed;
    next.status = "failed";
    next.problem = problem;
  });
}

}  // namespace morphgrid
