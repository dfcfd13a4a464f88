#pragma once
#include <variant>

#include "energy/frame_energy.h"
#include "energy/strut_energy.h"

namespace morphgrid {

/// The energy of a grid, of springs or of welded bars, as solvers judge it.
class GridEnergy {
 public:
  struct Value {
    double energy;    ///< In stiffness x the square of the scene's unit of length.
    double residual;  ///< Independent of the units of length and weight, and of the size.
  };

  /// Keeps a reference to the grid, which must be valid.
  explicit GridEnergy(const StrutGrid& grid);
  explicit GridEnergy(StrutGrid&&) = delete;

  /// positions: 3 x vertexCount. rotations: of a frame's joints. The residual is the norm of the
  /// gradient by displacements in spacings and turns in radians, over (mean stiffness x spacing^2 x
  /// sqrt(vertexCount)).
  Value evaluate(const Eigen::Matrix3Xd& positions, const JointRotations& rotations) const;

  /// Twice the mean, over all vertices, of what holds one: see StrutEnergy::constraintWeights(); of
  /// bars EA / 2 L.
  double meanStiffness() const { return meanStiffness_; }

 private:
  const StrutGrid& grid_;
  std::variant<StrutEnergy, FrameEnergy> energy_;
  double meanStiffness_;
};

}  // namespace morphgrid
