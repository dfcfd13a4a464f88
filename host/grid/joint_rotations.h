#pragma once
#include <Eigen/Core>

#include "grid/strut_grid.h"

namespace morphgrid {

/// How the joints of a frame have turned since they were printed: 4 x vertexCount, unit quaternions
/// (x, y, z, w) in space. Without columns for grids whose joints do not turn.
using JointRotations = Eigen::Matrix4Xd;

/// Joints that have not turned.
JointRotations unturnedJoints(int vertexCount);

/// Joints that turn as the bars at each of them do in the mean: the rotation of least squared
/// distance between the directions of its bars as printed, turned, and those at `positions`, 3 x
/// vertexCount (Kabsch 1976). None where the grid is no frame.
JointRotations turnWithBars(const StrutGrid& grid, const Eigen::Matrix3Xd& positions);

}  // namespace morphgrid
