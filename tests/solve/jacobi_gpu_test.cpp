#include <gtest/gtest.h>

#include "solve/jacobi_solver.h"
#include "solve/reference_solver.h"
#include "tests/solve/reference_problem.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

class JacobiReferenceAnswers : public DeviceTest,
                               public testing::WithParamInterface<const char*> {};

TEST_P(JacobiReferenceAnswers, PositionsAndEnergyMatch) {
  const ReferenceProblem problem = loadReferenceProblem(GetParam());
  DeviceGrid deviceGrid(device_, problem.grid);
  JacobiSolver solver(device_, problem.grid, deviceGrid);
  SolveOptions options;
  options.tolerance = getenv("TOL") ? atof(getenv("TOL")) : 1e-8;
  options.iterationLimit = 40000;
  const Equilibrium result = solver.solve(options);
  EXPECT_NEAR(result.energy / problem.minimumEnergy, 1, 1e-4);
  std::printf("%s: %ld iterations, %.2f s, residual %.2g, energy off by %.2g, positions %.2g %s\n",
              GetParam(), result.iterations, result.seconds, result.residual,
              result.energy / problem.minimumEnergy - 1,
              largestAlignedDistance(result.positions, problem.shapeopPositions),
              toString(result.reason).c_str());
  if (getenv("HIST"))
    for (size_t n = 0; n < result.history.size(); n += 40) {
      auto h = result.history[n];
      printf("%ld %.9g %.3g %.3g\n", h.iteration, h.energy, h.residual, h.seconds);
    }
}

INSTANTIATE_TEST_SUITE_P(ShapeOp, JacobiReferenceAnswers,
                         testing::Values("strip", "egg_chair_in_plane", "egg_chair",
                                         "saddle_patch"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace morphgrid
