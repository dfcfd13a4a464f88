#pragma once
#include <functional>
#include <limits>
#include <string>

#include "grid/joint_rotations.h"
#include "grid/strut_grid.h"

namespace morphgrid {

/// About the inverse of a grid's Hessian, times a vector: 3 x vertexCount in and out, of a frame 3
/// x 2 vertexCount, displacements in spacings, then turns. Symmetric and positive semidefinite; its
/// unit is of no account.
using Preconditioner = std::function<Eigen::Matrix3Xd(const Eigen::Matrix3Xd&)>;

/// Where a grid may move to.
enum class Motions {
  inSpace,
  inPlane,  ///< z stays fixed, as in the in-plane stage.
};

struct EigenvalueOptions {
  Motions motions = Motions::inSpace;
  double tolerance = 0.5;     ///< Bound on residual / |value|, > 0: below 1 the sign is certain.
  long iterationLimit = 500;  ///< >= 0
  /// A motion to begin with, as SmallestEigenvalue::motion of a grid nearby; empty: a random one.
  Eigen::Matrix3Xd start = {};
  /// It also ends as converged where the value less its residual is above: then the eigenvalue that
  /// is found is.
  double enough = std::numeric_limits<double>::infinity();
};

/// The smallest eigenvalue of the exact Hessian of the energy beyond the rigid motions, over the
/// mean stiffness (see StrutEnergy::residual()): twice the energy, in stiffness x spacing^2, that a
/// motion costs whose squared lengths, in spacings, and turns, in radians, add up to 1. Independent
/// of units.
struct SmallestEigenvalue {
  double value = 0;     ///< Rayleigh quotient of `motion`: the smallest eigenvalue is no larger.
  double residual = 0;  ///< |H z - value z|: an eigenvalue lies within it of the value.
  long iterations = 0;
  bool converged = false;
  double seconds = 0;
  Eigen::Matrix3Xd motion;  ///< z, 3 x vertexCount, of a frame 3 x 2 vertexCount, of norm 1.
};

/// What an eigenvalue says about an equilibrium.
enum class Verdict {
  minimum,    ///< Positive: no small motion lowers the energy. There may be other minima.
  saddle,     ///< Negative: there is a motion along which the energy falls.
  undecided,  ///< Zero within its residual, or not converged.
};

Verdict verdictOf(const SmallestEigenvalue& eigenvalue);

/// "minimum", "saddle", "undecided".
std::string toString(Verdict verdict);

/// Computes it by LOBPCG (Knyazev 2001), from a fixed random start unless there is a better one.
/// positions: 3 x vertexCount, an equilibrium in the scene's unit of length; elsewhere rotations
/// are no eigenvectors, but taken out all the same. Stops early when the user interrupts. Throws
/// DeviceError when the preconditioner gives no numbers.
SmallestEigenvalue computeSmallestEigenvalue(const StrutGrid& grid,
                                             const Eigen::Matrix3Xd& positions,
                                             const Preconditioner& preconditioner,
                                             const EigenvalueOptions& options = {});

/// The same of a frame, whose joints have turned; in space.
SmallestEigenvalue computeSmallestEigenvalue(const StrutGrid& grid,
                                             const Eigen::Matrix3Xd& positions,
                                             const JointRotations& rotations,
                                             const Preconditioner& preconditioner,
                                             const EigenvalueOptions& options = {});

}  // namespace morphgrid
