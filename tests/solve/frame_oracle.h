#pragma once
#include <string>
#include <vector>

#include "grid/strut_grid.h"

namespace morphgrid {

/// A frame, and where an independent solver in double precision says that it comes to rest:
/// Newton's method on differentiated energies, see tests/solve/frames/README.md.
struct FrameOracle {
  StrutGrid grid;
  double energy;
  Eigen::Matrix3Xd positions;  ///< 3 x vertexCount
};

/// name: of a file in tests/solve/frames. thickness: of its square bars, in mean lateral rest
/// lengths; one of the file's.
FrameOracle loadFrameOracle(const std::string& name, double thickness);

/// RMS and largest distance of points to others once the first are aligned rigidly, in percent of
/// the others' box's diagonal.
struct Mismatch {
  double rms, largest;
};
Mismatch mismatchOf(const Eigen::Matrix3Xd& points, const Eigen::Matrix3Xd& others);

}  // namespace morphgrid
