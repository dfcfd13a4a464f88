#pragma once
#include <vector>

#include "grid/bar_section.h"
#include "grid/joint_rotations.h"
#include "grid/strut_grid.h"

namespace morphgrid {

/// The grid with its struts as bars of that size, printed where it starts; their modulus makes EA
/// of lateral ones twice their spring's stiffness times the spacing.
StrutGrid welded(StrutGrid grid, const BarSize& size);

/// The frame with joints that are held, and a weight of so much a unit of EA and of printed length
/// on all joints.
StrutGrid weighedDown(StrutGrid grid, const Eigen::Vector3d& weightPerStiffness,
                      std::vector<int> held, bool slide = false);

/// Where a frame may be, away from rest: joints moved by up to `move` in each coordinate and turned
/// by up to `turn` about each axis.
struct FramePlace {
  Eigen::Matrix3Xd positions;
  JointRotations rotations;
};
FramePlace shakenFrame(const StrutGrid& grid, double move, double turn, unsigned seed);

}  // namespace morphgrid
