#include "tests/solve/frame_oracle.h"

#include "tests/support/folders.h"

namespace morphgrid {

FrameReference loadSolveReference(const std::string& name) {
  return loadFrameReference(sourceFolder() / "tests/solve/frames" / (name + ".json"));
}

FrameOracle loadFrameOracle(const std::string& name, double thickness) {
  const FrameReference reference = loadSolveReference(name);
  const FrameReference::Answer& answer = reference.answerAt(thickness);
  return {asFrame(reference.grid, thickness * reference.meanLateralRest(), reference.poisson,
                  kPointJoint),
          answer.energy.value(), answer.positions};
}

}  // namespace morphgrid
