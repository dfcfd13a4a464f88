#pragma once
#include <Eigen/Core>

namespace morphgrid {

/// Points of a surface in rows along u and columns along v.
struct PointLattice {
  int countU;  ///< >= 2
  int countV;
  Eigen::Matrix3Xd points;  ///< 3 x countU countV, index j countU + i.

  int index(int i, int j) const { return j * countU + i; }
  Eigen::Vector3d at(int i, int j) const { return points.col(index(i, j)); }
};

}  // namespace morphgrid
