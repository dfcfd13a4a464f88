#pragma once
#include <deque>
#include <string>
#include <vector>

#include "inverse/bounded_lbfgs.h"
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
  int number;         ///< Counts the steps of its kind, from 1; 0 for the design.
  double rmsPercent;  ///< Distance to the target, see ShapeError.
  double maxPercent;
  double largestShrinkPercent;  ///< 1 - rest / printed length, over all lateral struts.
  double largestStrainPercent;  ///< |length - rest| / rest at the equilibrium, of lateral struts.
  long strutsAtBound;
  long cycles;          ///< V-cycles of multigrid, to the new equilibria.
  int adjointProducts;  ///< Hessian products and cycles of the adjoint.
  double seconds;       ///< Since inverse design began.
};

/// "design", "compensate", "optimise".
std::string toString(InverseStep::Kind kind);

/// Where inverse design stands: enough to go on from, in another process too.
struct InverseCheckpoint {
  /// Lateral rest lengths, in the order of LateralRest, and the grid's equilibrium with them.
  struct Design {
    Eigen::VectorXd rest;
    Equilibrium equilibrium;
  };

  bool compensated = false;  ///< Rounds of spring-back correction are over.
  Design present;
  Design kept;                ///< The last one that was settled, see InverseDesigner.
  std::size_t keptSteps = 0;  ///< How many of `steps` lead to it.
  int returns = 0;            ///< How often the grid has left for another equilibrium.
  std::vector<InverseStep> steps;
  std::vector<double> objectives;  ///< After each step of optimisation.
  std::deque<BoundedLbfgs::Pair> pairs;
  Eigen::Matrix3Xd aim = Eigen::Matrix3Xd(3, 0);  ///< Of AimCorrection, where there is one.
};

/// Throws InputError unless it is of a grid of so many lateral struts and vertices.
void requireSizes(const InverseCheckpoint& checkpoint, Eigen::Index lateralStruts,
                  Eigen::Index vertices);

}  // namespace morphgrid
