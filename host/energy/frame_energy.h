#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "energy/beam_term.h"
#include "energy/joint_term.h"
#include "grid/joint_rotations.h"
#include "grid/strut_grid.h"

namespace morphgrid {

/// Where a frame is: 3 x vertexCount, and the joints' rotations.
struct FramePlacement {
  const Eigen::Matrix3Xd& positions;
  const JointRotations& rotations;

  BeamTerm::Ends<double> endsOf(const BeamTerm& term, const Edge& edge) const;
  Eigen::Quaterniond rotationOf(int joint) const {
    return Eigen::Quaterniond(rotations.col(joint));
  }
};

/// Of a vector of a frame's unknowns, 3 x 2 vertexCount: how a bar's ends move.
BeamTerm::Vector9<double> changeOfEnds(const Edge& edge, const Eigen::Matrix3Xd& unknowns);

/// The energy of a grid of welded bars (StrutGrid::bars), the sum of its beam and joint terms, in
/// double precision: the oracle for the device. Vectors of
/// unknowns are 3 x 2 vertexCount: a displacement of every joint, then a turn of every joint.
class FrameEnergy {
 public:
  struct Value {
    double energy;              ///< In stiffness x the square of the scene's unit of length; below
                                ///< 0 where weights have done more work than bars have taken up.
    Eigen::Matrix3Xd gradient;  ///< 3 x 2 vertexCount: forces, then moments.
  };

  /// Keeps a reference to the grid, which must be valid and have bars.
  explicit FrameEnergy(const StrutGrid& grid) : grid_(grid) {}
  explicit FrameEnergy(StrutGrid&&) = delete;

  /// positions: 3 x vertexCount.
  Value evaluate(const Eigen::Matrix3Xd& positions, const JointRotations& rotations) const;

  /// The exact Hessian, or each bar's positive part of it: square, of 6 vertexCount, the unknowns
  /// of a joint together (displacement, turn), the lower half alone. Symmetric where joints bear no
  /// moments; elsewhere its symmetric part.
  enum class Definiteness { exact, positiveParts };
  Eigen::SparseMatrix<double> hessian(const Eigen::Matrix3Xd& positions,
                                      const JointRotations& rotations,
                                      Definiteness definiteness) const;

  /// The Hessian's product with a vector of unknowns, exactly.
  Eigen::Matrix3Xd hessianProduct(const Eigen::Matrix3Xd& positions,
                                  const JointRotations& rotations,
                                  const Eigen::Matrix3Xd& motion) const;

 private:
  const StrutGrid& grid_;
};

}  // namespace morphgrid
