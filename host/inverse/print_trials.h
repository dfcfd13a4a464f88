#pragma once
#include <cstdint>
#include <optional>

#include "inverse/lateral_rest.h"
#include "inverse/shape_error.h"
#include "solve/multigrid_solver.h"

namespace morphgrid {

/// Where a grid comes to rest whose rest lengths are other than they should be.
struct PrintTrial {
  ShapeError error;
  bool isConverged;
  bool isJump;  ///< With the right lengths again it does not come back: another equilibrium.
};

/// Solves a grid again and again with rest lengths that are off, each time from its equilibrium
/// with the right ones.
class PrintTrials {
 public:
  /// The solver's grid has the right rest lengths. near: about where it is at rest; goal: 3 x
  /// layerVertexCount. Keeps references. Throws DeviceError when the device fails, as what follows.
  PrintTrials(MultigridSolver& solver, const Equilibrium& near, const Eigen::Matrix3Xd& goal,
              SolveOptions options);

  /// With the right rest lengths.
  const Equilibrium& equilibrium() const { return centre_; }
  const ShapeError& error() const { return error_; }

  PrintTrial tryWith(const StrutValues& rest);

  /// d RMS distance / d lateral rest length, in percent over the scene's unit, in the order of
  /// LateralRest: exact to first order. Nothing where the distance is about zero, which has no
  /// slope, or the adjoint does not converge.
  std::optional<Eigen::VectorXd> slope();

  /// How far changes of lateral rest lengths move the middle layer, to first order: the matrix G
  /// for which |G change|^2 is, in the mean over seeds, the square of the movement (RMS, percent of
  /// the diagonal, rigid motions left out). A row is the adjoint gradient of a random projection of
  /// that movement; so many rows give it within 1 / sqrt(2 rows).
  Eigen::MatrixXd movements(int rows, std::uint64_t seed);

 private:
  void place(const StrutValues& rest);
  bool comesBack(const Eigen::Matrix3Xd& middle);
  Eigen::MatrixXd rigidMotions() const;

  MultigridSolver& solver_;
  const Eigen::Matrix3Xd& goal_;
  SolveOptions options_;
  StrutValues rest_;  ///< The right one.
  Equilibrium centre_;
  ShapeError error_;
};

}  // namespace morphgrid
