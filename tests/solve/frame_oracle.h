#pragma once
#include <string>

#include "benchmark/frame_reference.h"

namespace morphgrid {

/// name: of a file in tests/solve/frames.
FrameReference loadSolveReference(const std::string& name);

/// A frame, and where an independent solver in double precision says that it comes to rest:
/// Newton's method on differentiated energies, see tests/solve/frames/README.md.
struct FrameOracle {
  StrutGrid grid;
  double energy;
  Eigen::Matrix3Xd positions;  ///< 3 x vertexCount
};

/// thickness: of its square bars, in mean lateral rest lengths; one of the file's.
FrameOracle loadFrameOracle(const std::string& name, double thickness);

}  // namespace morphgrid
