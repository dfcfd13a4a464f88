#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grid/shrink.h"
#include "inverse/check_from_flat.h"
#include "inverse/inverse_checkpoint.h"
#include "inverse/lateral_rest.h"
#include "inverse/shape_error.h"
#include "inverse/softness.h"
#include "inverse/strain_excess.h"
#include "solve/checkpoint_pace.h"
#include "solve/multigrid_solver.h"

namespace morphgrid {

struct InverseOptions {
  int compensateRounds = 0;  ///< >= 0
  int optimiseSteps = 0;     ///< >= 0
  /// Every strut keeps to them; their lengths are in the unit of the grid.
  std::optional<ShrinkBounds> shrinkBounds;
  /// |length - rest| / rest of lateral struts beyond it counts as distance does, > 0.
  std::optional<double> maxStrain;
  /// Of frames: a step that leaves less Softness than this, and than there is, is refused.
  double softest = kSoftest;
  /// Lateral rest lengths that lead to points of the middle layer, 3 x layerVertexCount, as far as
  /// geometry knows. Where it is given, rounds of correction aim beyond the target; else they work
  /// strut by strut.
  std::function<Eigen::VectorXd(const Eigen::Matrix3Xd& points)> lengthsFor;
  SolveOptions solve;                              ///< For the last equilibrium.
  std::function<void(const InverseStep&)> onStep;  ///< May be empty.
  /// Called when the design is chosen and the solver stands at it, before the solver's grid leaves
  /// for the check from flat; may be empty.
  std::function<void()> onCheckFromFlat;
  FromFlatProgress onFromFlat;  ///< May be empty.
  /// Called with where inverse design stands, as often as costs 1 % of the time, and when it has to
  /// end early; may be empty.
  std::function<void(InverseCheckpoint)> onCheckpoint;
  /// Where an inverse design of the same grid, targets and bounds stood. Steps and seconds count
  /// on.
  std::optional<InverseCheckpoint> resumeFrom;
};

struct InverseDesign {
  StrutValues rest;                ///< The design that was kept.
  Equilibrium equilibrium;         ///< That of the design.
  std::vector<InverseStep> steps;  ///< The steps that led to it.
  /// "all steps done", "the distance no longer falls", "interrupted", "device failure", "in step N
  /// the grid left for another equilibrium".
  std::string ending;
  std::optional<FromFlat> fromFlat;  ///< None where inverse design ended early.
  int refusedAsSoft = 0;             ///< Steps that would have left a frame near buckling.
};

/// Chooses lateral rest lengths so that the simulated grid, not the single strut, meets its target:
/// first spring-back correction, then L-BFGS on the adjoint gradient over the box of what a strut
/// may do (docs/method.md, Inverse design). Each equilibrium starts from the last one, less tightly
/// solved; every so often a design is settled: solved to the end and, if it holds, kept.
class InverseDesigner {
 public:
  /// The solver's grid is stacked, at the positions where it is printed, with its designed rest
  /// lengths. targets: 3 x layerVertexCount. Keeps references.
  InverseDesigner(MultigridSolver& solver, const Eigen::Matrix3Xd& targets, InverseOptions options);

  /// first: the designed grid's equilibrium. The solver holds the design that is kept afterwards.
  /// Throws DeviceError when the device fails, InputError when the checkpoint to resume from is of
  /// another grid.
  InverseDesign run(Equilibrium first);

  /// The design reached when run() has thrown DeviceError; nothing when there was none yet.
  std::optional<InverseDesign> salvage() const;

 private:
  struct State {
    Eigen::VectorXd rest;
    Equilibrium equilibrium;
    ShapeError error;
    double objective;  ///< That of the distance, and of strains beyond the bound.
  };

  void begin(Equilibrium first);
  void resume(InverseCheckpoint from);
  State stateOf(InverseCheckpoint::Design design) const;
  InverseCheckpoint checkpoint() const;
  void compensate();
  int roundsDone() const;
  void correctLengths();
  void aimBeyond();
  void optimise();
  /// One step of optimisation.
  enum class Outcome { better, searchesAnew, fallsNoFurther };
  Outcome improve(Eigen::VectorXd& slope, int step);
  void keep();
  bool settle();
  void morphFromFlat();
  bool searchLine(const Eigen::VectorXd& direction);
  /// Brings the solver to where the present state is.
  void place();
  State morphed(const Eigen::VectorXd& rest, const SolveOptions& solve);
  Eigen::VectorXd gradient();
  StrainExcess excessOf(const InverseCheckpoint::Design& design) const;
  double largestStrain(const State& state) const;
  bool isBetter(const State& trial) const;
  bool strainsNoMore(const State& trial) const;
  bool staysFirm(const State& trial);
  void log(InverseStep::Kind kind, int number);
  void offerCheckpoint();
  bool falls() const;

  MultigridSolver& solver_;
  const Eigen::Matrix3Xd& targets_;
  InverseOptions options_;
  SolveOptions onTheWay_;  ///< For equilibria that are only steps.
  SolveOptions toTheEnd_;
  LateralRest lateral_;
  Eigen::VectorXd designed_;
  Eigen::VectorXd printed_;
  Eigen::VectorXd low_;
  Eigen::VectorXd high_;
  double diagonal_;  ///< Of the targets.
  BoundedLbfgs lbfgs_;
  CheckpointPace<InverseCheckpoint> pace_;
  State state_;
  bool isPlaced_ = false;  ///< The solver stands at state_.
  State kept_;
  std::size_t keptSteps_ = 0;
  bool compensated_ = false;
  Eigen::Matrix3Xd aim_;
  std::optional<SoftnessBound> softness_;  ///< Of frames.
  InverseDesign result_;
  std::vector<double> objectives_;  ///< After each step of optimise().
  long cycles_ = 0;
  int products_ = 0;
  double start_ = 0;
};

}  // namespace morphgrid
