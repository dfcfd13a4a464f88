#include "app/simulate_scene.h"

#include <fmt/format.h>

#include "app/activity_line.h"
#include "core/bounding_diagonal.h"
#include "core/free_memory.h"
#include "core/rigid_alignment.h"

namespace morphgrid {
namespace {

void noteSaddle(RunRecord& record, const char* stage, const Equilibrium& equilibrium) {
  if (verdictOf(equilibrium) == Verdict::saddle) {
    record.notices.push_back(
        {fmt::format("the {} stage ended at a saddle, not at a minimum: there is a motion along "
                     "which the energy "
                     "falls; try another solver.method, grid.layer_spacing or grid.nodes_long",
                     stage),
         Severity::result});
  }
}

void noteOtherWay(RunRecord& record) {
  const auto& inverse = record.inverse;
  if (!inverse || !inverse->fromFlat) return;
  if (!inverse->fromFlat->isSettled) {
    record.notices.push_back(
        {fmt::format("whether the optimised grid gets to its design from flat is not known: the "
                     "check did not come to rest within {} cycles; try another "
                     "grid.layer_spacing or design.optimise",
                     inverse->fromFlat->cycles),
         Severity::result});
  } else if (!inverse->fromFlat->sameEquilibrium) {
    record.notices.push_back(
        {fmt::format("the optimised grid has more than one equilibrium: from flat it morphs into "
                     "another, {:.3g} % (RMS) from the target; help it by hand, or try another "
                     "grid.layer_spacing or design.optimise",
                     inverse->fromFlat->rmsPercent),
         Severity::result});
  }
}

void noteSoftness(RunRecord& record) {
  const auto& inverse = record.inverse;
  if (inverse && inverse->fromFlat && inverse->fromFlat->leastStiffness.value_or(1) < kSoftest) {
    record.notices.push_back(
        {fmt::format("on its way from flat the grid comes close to buckling: its smallest "
                     "eigenvalue falls to {:.2g} of the flat sheet's; lower grid.layer_spacing, or "
                     "take a material of a wider range (material.least_shrinkage, "
                     "grid.max_shrinkage) or a surface that curves less",
                     *inverse->fromFlat->leastStiffness),
         Severity::printing});
  }
  if (inverse && inverse->refusedAsSoft > 0) {
    record.notices.push_back(fmt::format(
        "inverse design refused {} steps, after which the grid would be near buckling; a wider "
        "range of the material (material.least_shrinkage, grid.max_shrinkage) or a surface that "
        "curves less leaves it more",
        inverse->refusedAsSoft));
  }
}

/// Percent of the diagonal; beyond it a grid that should be symmetric is seen to curl.
constexpr double kAsymmetric = 0.05;

void noteAsymmetry(RunRecord& record) {
  const auto& symmetry = record.symmetry;
  if (symmetry && symmetry->resultPercent > kAsymmetric) {
    record.notices.push_back(
        {fmt::format("the target is symmetric under a {}, the result is not, by {:.2g} % (RMS): it "
                     "has buckled to one side, and its mirror twin is as likely; a sheet that fits "
                     "(design.layout = \"conformal\"), thicker bars or less shrinkage keep it "
                     "from that",
                     toString(symmetry->kind), symmetry->resultPercent),
         Severity::result});
  }
}

/// Brings the result to where the target lies; without a target, to where it was printed, unless
/// something holds it.
Eigen::Isometry3d alignResult(const Stage& stage, const std::optional<Eigen::Matrix3Xd>& targets) {
  const Eigen::Matrix3Xd& positions = stage.equilibrium.positions;
  if (targets) {
    return alignRigidly(middleLayer(stage.grid.shape, positions), *targets);
  }
  const bool isHeld = stage.grid.bars && stage.grid.bars->loads;
  return isHeld ? Eigen::Isometry3d::Identity() : alignRigidly(positions, stage.grid.positions);
}

/// Both take longer than a large run that is interrupted may.
constexpr const char* kNotExamined =
    "interrupted: neither the target's closest points nor cells that are inverted or pass through "
    "others were looked for";

/// What of the design and of its result cannot be printed, or cannot be.
void assessPrintability(const Stage& stage, const Scene& scene, RunRecord& record) {
  const auto tell = [&](const std::vector<std::string>& advice, Severity severity) {
    for (const std::string& text : advice) record.notices.push_back({text, severity});
  };
  if (record.full) {
    record.shrink = computeShrink(stage.grid, stage.shrinkBounds);
    if (scene.print) {
      record.print = assessPrint(stage.grid, scene.print->tools, designBoundsOf(scene));
    } else {
      tell(adviseOn(*record.shrink, stage.shrinkBounds.material), Severity::printing);
    }
    const std::optional<double>& limit = scene.design.maxStrain;
    record.strain = computeStrain(stage.grid, stage.equilibrium.positions, limit);
    if (limit) tell(adviseOn(*record.strain, *limit), Severity::printing);
  }
  if (scene.solve.stopRequested()) {
    record.notices.emplace_back(kNotExamined);
    return;
  }
  record.feasibility = examineFeasibility(stage.grid.shape, stage.equilibrium.positions,
                                          strutThicknessOf(scene, stage.mmPerUnit));
  const bool canBe =
      record.feasibility->cells.inverted == 0 && record.feasibility->selfIntersection.cells == 0;
  tell(adviseOn(*record.feasibility), canBe ? Severity::printing : Severity::result);
}

}  // namespace

Simulation simulateScene(const Scene& scene, const SceneDesign& designed, RunContext& context,
                         CheckpointKeeper& keeper, bool quiet) {
  const Cancellation cancellation(scene.solve.isCancelled);
  RunRecord record = recordOf(scene, designed);
  record.device =
      scene.method == Method::reference ? "CPU, double precision" : context.device->name();

  Stages stages(scene, context, keeper, quiet);
  Stage stage =
      stages.runInPlane(designed.design, designed.sheet ? &designed.sheet->sheet : nullptr);
  record.inPlane = stage.equilibrium;
  if (record.inPlane->reason == StopReason::interrupted && record.inPlane->iterations == 0) {
    throw Cancelled();
  }
  noteSaddle(record, "in-plane", *record.inPlane);
  if (designed.design.layers > 1) {
    stage = stages.runFull(designed, record.inPlane->positions);
    record.printScale = stage.printScale;
    if (designed.targets) {
      const StageEffort before{stage.equilibrium.iterations, stage.equilibrium.seconds};
      record.inverse = stages.improve(stage, designed);
      if (record.inverse) record.beforeInverse = before;
      noteOtherWay(record);
      noteSoftness(record);
    }
    record.weight = stages.assessWeight(stage);
    if (record.weight) {
      for (const std::string& notice :
           adviseOn(*record.weight, boundingDiagonal(stage.grid.positions))) {
        record.notices.push_back(notice);
      }
    }
    stage.solver.reset();  // Its memory is for files and pictures now.
    returnFreedMemory();
    const MaterialRequest material = materialOf(scene, stage.mmPerUnit);
    record.bars = barSizesOf(stage.grid, material);
    for (const std::string& notice : adviseOnBars(stage.grid, material)) {
      record.notices.push_back(notice);
    }
    record.full = stage.equilibrium;
    noteSaddle(record, "full", *record.full);
  }

  cancellation.check();
  const bool isInterrupted = scene.solve.stopRequested();
  const ActivityLine examining("examining the result", quiet);
  const Eigen::Matrix3Xd& positions = stage.equilibrium.positions;
  const auto sheet = stage.grid.positions.topRows<2>();
  record.printedSheet = sheet.rowwise().maxCoeff() - sheet.rowwise().minCoeff();
  record.errors = computeStrutErrors(designed.design, stage.grid, positions);
  cancellation.check();
  assessPrintability(stage, scene, record);
  cancellation.check();
  if (designed.targets) {
    record.distance =
        computeTargetDistance(middleLayer(stage.grid.shape, positions), *designed.targets,
                              isInterrupted ? nullptr : &designed.target->closestPoints());
    record.symmetry = computeSymmetry(stage.grid.shape, *designed.targets,
                                      middleLayer(stage.grid.shape, positions));
    noteAsymmetry(record);
  }
  record.isInterrupted = scene.solve.stopRequested();
  putMostImportantFirst(record.notices);
  const Eigen::Isometry3d targetFromGrid = alignResult(stage, designed.targets);
  return {std::move(record), std::move(stage), targetFromGrid};
}

}  // namespace morphgrid
