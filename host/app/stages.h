#pragma once
#include "app/checkpoint_keeper.h"
#include "app/progress_line.h"
#include "app/run_context.h"
#include "inverse/inverse_design.h"
#include "solve/multigrid_solver.h"

namespace morphgrid {

/// A grid on its way to equilibrium, with its copy on the device.
struct Stage {
  StrutGrid grid;
  std::shared_ptr<DeviceGrid> onDevice{};  ///< None in runs on the CPU, or when it did not fit.
  /// Only of Method::multigrid, and while the stage is solved.
  std::shared_ptr<MultigridSolver> solver{};
  Equilibrium equilibrium{};
  double printScale = 1;  ///< How much the flat sheet was enlarged, see choosePrintScale().
  std::optional<double> mmPerUnit{};  ///< At which it is printed; only with [print].
  ShrinkBounds shrinkBounds{};        ///< What its struts can lose, in the unit of the grid.
};

/// The two stages of a run. A device that fails ends a solve where it stood.
class Stages {
 public:
  /// Keeps references.
  Stages(const Scene& scene, RunContext& context, CheckpointKeeper& keeper, bool quiet)
      : scene_(scene), context_(context), keeper_(keeper), quiet_(quiet) {}

  /// One layer of square cells morphs in its plane to what is printed; where a sheet has been laid
  /// out, it is that.
  Stage runInPlane(const GridDesign& design, const Sheet* sheet);
  /// The printed layer, enlarged when every strut has to shrink within the material's bound and it
  /// was not laid out for that, and stacked, morphs in space.
  Stage runFull(const SceneDesign& designed, const Eigen::Matrix3Xd& printedLayer);
  /// Other rest lengths, which bring the full stage closer to its targets (SceneDesign::targets),
  /// as the scene asks for; nothing when it does not or the device fails before the first. Then the
  /// stage stays.
  std::optional<InverseDesign> improve(Stage& stage, const SceneDesign& designed);
  /// What weight does to a stage at its equilibrium; nothing without gravity.
  std::optional<WeightFigures> assessWeight(const Stage& stage);

 private:
  /// Brings a stage that has its grid to the device.
  Stage prepare(Stage stage);
  void reachPrintedLayer(Stage& stage, const Sheet* sheet);
  void solve(Stage& stage, const char* name, const Eigen::Matrix3Xd& near);
  StageOutlook outlookOf(const StrutGrid& grid) const;
  std::optional<Equilibrium> solveByMethod(Stage& stage, const SolveOptions& options);
  void showOnDevice(const Stage& stage);
  void assessStability(Stage& stage, Motions motions);
  void assessDesign(Stage& stage);
  Equilibrium untouched(const StrutGrid& grid) const;
  Equilibrium lastKnown(const StrutGrid& grid) const;

  const Scene& scene_;
  RunContext& context_;
  CheckpointKeeper& keeper_;
  bool quiet_;
};

}  // namespace morphgrid
