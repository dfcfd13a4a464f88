#pragma once
#include <filesystem>
#include <string>

#include "grid/strut_grid.h"

namespace morphgrid {

/// A problem of tests/reference with ShapeOp's answer to it.
struct ReferenceProblem {
  StrutGrid grid;
  Eigen::Matrix3Xd shapeopPositions;
  double shapeopEnergy;
  double minimumEnergy;
};

ReferenceProblem loadReferenceProblem(const std::string& name);

/// Largest distance between matching points after the best rigid alignment.
double largestAlignedDistance(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to);

}  // namespace morphgrid
