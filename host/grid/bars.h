#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "grid/grid_topology.h"

namespace morphgrid {

/// How a bar resists, and how much of it is rigid. Lengths in the scene's unit; E is in stiffness x
/// length^-1, so that energies are in stiffness x length^2 as those of springs are.
struct BarSection {
  double stretching = 0;  ///< EA, > 0
  double bendingN = 0;    ///< EI where it bends in the sheet's plane as printed; posts along x. > 0
  double bendingB = 0;    ///< EI where it bends across, > 0
  double twisting = 0;    ///< GJ, > 0
  double shearing = 0;    ///< 1 / (5/6 G A), >= 0; 0: it does not shear (Euler-Bernoulli).
  double joint = 0;       ///< Rigid part at either end, >= 0 and less than half the rest length.
};

/// What acts on joints from outside.
struct JointLoads {
  Eigen::Matrix3Xd forces;  ///< 3 x vertexCount, stiffness x length; they keep their direction.
  std::vector<int> held;    ///< Joints that stay where and as they were printed, at least one.
  bool slide = false;       ///< They keep their height z alone: three at least, not in line.
};

/// The struts of a grid as bars that are welded to their joints, at the angles at which they were
/// printed.
struct Bars {
  BarSection lateral;
  BarSection upright;        ///< Of posts.
  Eigen::Matrix3Xd printed;  ///< 3 x vertexCount: positions as printed, each layer in a plane of
                             ///< equal z and posts along z.
  std::optional<JointLoads> loads = std::nullopt;

  const BarSection& section(const Strut& strut) const {
    return strut.isLateral() ? lateral : upright;
  }
};

/// Of a bar as printed, a unit vector.
inline Eigen::Vector3d printedDirection(const Bars& bars, const Strut& strut) {
  return (bars.printed.col(strut.to) - bars.printed.col(strut.from)).normalized();
}

}  // namespace morphgrid
