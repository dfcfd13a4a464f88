#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "inverse/bounded_lbfgs.h"
#include "inverse/lateral_rest.h"
#include "inverse/shape_error.h"
#include "solve/adjoint_solver.h"
#include "solve/device_grid.h"
#include "solve/equilibrium.h"

namespace morphgrid {

/// One change of the rest lengths, with the grid solved again.
struct InverseStep {
  enum class Kind {
    design,      ///< The design as it came, within the bounds.
    compensate,  ///< Spring-back correction.
    optimise,    ///< A step along the adjoint gradient.
  };
  Kind kind;
  int number;         ///< Of its kind, from 1; 0 for the design.
  double rmsPercent;  ///< Distance to the target, see ShapeError.
  double maxPercent;
  double largestShrinkPercent;  ///< 1 - rest / printed length, over all lateral struts.
  long strutsAtBound;
  long cycles;          ///< Of multigrid, to the new equilibria.
  int adjointProducts;  ///< Hessian products and cycles of the adjoint.
  double seconds;       ///< Since inverse design began.
};

/// "design", "compensate", "optimise".
std::string toString(InverseStep::Kind kind);

struct InverseOptions {
  int compensateRounds = 0;           ///< >= 0
  int optimiseSteps = 0;              ///< >= 0
  std::optional<double> shrinkLimit;  ///< Share of its printed length that a strut may lose.
  SolveOptions solve;                 ///< Of the last equilibrium.
  std::function<void(const InverseStep&)> onStep;  ///< May be empty.
};

/// Where the chosen design gets by a slow morph from the printed sheet, see followMorph().
struct FromFlat {
  bool sameEquilibrium;  ///< That of the inverse design.
  double rmsPercent;     ///< Distance to the target, see ShapeError.
};

struct InverseDesign {
  Equilibrium equilibrium;         ///< Of the design that was kept.
  std::vector<InverseStep> steps;  ///< Up to the design that was kept.
  /// "all steps done", "the distance no longer falls", "interrupted", "in step N the grid left for
  /// another equilibrium".
  std::string ending;
  std::optional<FromFlat> fromFlat;  ///< Not after an interruption.
};

/// Chooses lateral rest lengths so that the simulated grid, not the single strut, meets its target:
/// first spring-back correction, then L-BFGS on the adjoint gradient over the box of what a strut
/// may do. Each equilibrium starts from the last one.
class InverseDesigner {
 public:
  /// grid: stacked, at the positions where it is printed, with its designed rest lengths; gets the
  /// new ones. targets: 3 x layerVertexCount. Keeps references; the device grid holds the grid.
  InverseDesigner(const Device& device, StrutGrid& grid, DeviceGrid& deviceGrid,
                  const Eigen::Matrix3Xd& targets, InverseOptions options);

  /// first: the designed grid's equilibrium. Throws DeviceError when the device fails.
  InverseDesign run(Equilibrium first);

 private:
  struct State {
    Eigen::VectorXd rest;
    Equilibrium equilibrium;
    ShapeError error;
  };

  void begin(Equilibrium first);
  void compensate();
  void optimise();
  void keep();
  bool settle();
  void morphFromFlat();
  bool searchLine(const Eigen::VectorXd& direction);
  State morphed(const Eigen::VectorXd& rest, double energyTolerance);
  Eigen::VectorXd gradient();
  void log(InverseStep::Kind kind, int number);
  bool falls() const;

  const Device& device_;
  StrutGrid& grid_;
  DeviceGrid& deviceGrid_;
  const Eigen::Matrix3Xd& targets_;
  InverseOptions options_;
  LateralRest lateral_;
  Eigen::VectorXd designed_;
  Eigen::VectorXd printed_;
  Eigen::VectorXd low_;
  Eigen::VectorXd high_;
  BoundedLbfgs lbfgs_;
  AdjointSolver adjoint_;
  State state_;
  State kept_;
  std::size_t keptSteps_ = 0;
  InverseDesign result_;
  std::vector<double> objectives_;  ///< After each step of optimise().
  long cycles_ = 0;
  int products_ = 0;
  double start_ = 0;
};

}  // namespace morphgrid
