#pragma once
#include "solve/lbfgs_vectors.h"
#include "solve/v_cycle.h"

namespace morphgrid {

/// L-BFGS on one grid, its initial inverse Hessian one V-cycle of multigrid: vectors on the device,
/// decisions here. Lengths in units of the spacing, energies in stiffness x spacing^2.
class PreconditionedDescent {
 public:
  /// Keeps references. Begins at the device grid's positions.
  PreconditionedDescent(const Device& device, DeviceGrid& grid, Precision precision);

  /// Begins anew at the device grid's positions, which may have changed as its rest lengths may.
  /// keepsHessian: the one taken last serves on, until the energy does not fall as it says.
  void begin(bool keepsHessian);
  /// The next step takes the Hessian anew, whatever begin() is told.
  void forgetHessian() { linearisationIsStale_ = true; }

  /// One V-cycle and a step downhill. False when no step lowers the energy, even with damping: at
  /// this precision it falls no further.
  bool iterate();

  /// The positions reached so far, 3 x vertexCount, in the scene's unit of length.
  Eigen::Matrix3Xd positions() const {
    return grid_.downloadPositions(vectors_.currentPositions());
  }
  /// Of a frame.
  JointRotations rotations() const { return grid_.downloadRotations(vectors_.currentPositions()); }
  double energy() const { return sums_.energy; }
  double gradientNorm() const;
  /// How far the energy would have fallen in the last step, were it quadratic, also where no step
  /// lowered it; infinite before the first.
  double predictedDecrease() const { return predictedDecrease_; }

  /// Brings the positions reached to DeviceGrid::positions().
  void finish();

  /// Takes the Hessian, undamped, at the positions reached: for others who use its cycle,
  /// correction = about H^-1 rightSide, between finish() and begin().
  void takeHessian();
  VCycle& cycle() { return cycle_; }
  const VertexVector& rightSide() const { return vectors_.rightSide(); }
  const VertexVector& correction() const { return vectors_.correction(); }
  const VertexVector& direction() const { return vectors_.direction(); }
  /// See DeviceGrid::vectorLength().
  int vectorLength() const { return grid_.vectorLength(); }

 private:
  void linearise();
  bool descend();
  /// The direction, and the trial state a full step along it: most often the one that is taken.
  void tryFullStep(const PairHistory::Weights& weights);
  void tryStep(double length);
  /// Along the direction, whose slope is -descent, from the full step on.
  bool searchLine(double descent);
  bool modelFails(double decrease) const;

  DeviceGrid& grid_;
  double energyRounding_;
  LbfgsVectors vectors_;
  VCycle cycle_;
  CommandStream stream_;
  PairHistory history_;
  Dots dots_{};
  GridGradient::Sums sums_{};
  double predictedDecrease_;
  double damping_ = 0;
  int stepsSinceLinearisation_ = 0;
  bool linearisationIsStale_ = true;
  bool linearisationIsHere_ = false;  ///< At the positions reached.
};

}  // namespace morphgrid
