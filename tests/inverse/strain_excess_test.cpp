#include "inverse/strain_excess.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/solve/sample_grids.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

TEST(StrainExcess, IsNothingWithinTheBound) {
  const StrutGrid grid = bentGrid({4, 3, 2}, 5);
  const LateralRest lateral(grid.shape);
  const VectorXd lengths = lateral.lengthsAt(grid.positions);
  EXPECT_EQ(computeStrainExcess(lateral, lengths / 1.0299, grid.positions, 0.03, 1).penalty, 0);
  EXPECT_NEAR(computeStrainExcess(lateral, lengths / 1.05, grid.positions, 0.03, 10).penalty,
              100 * lateral.size() * 0.02 * 0.02 / 2, 1e-9);
}

TEST(StrainExcess, DerivativesAreThoseOfFiniteDifferences) {
  const StrutGrid grid = bentGrid({4, 3, 2}, 5);
  const LateralRest lateral(grid.shape);
  std::srand(2);
  const VectorXd rest =
      lateral.lengthsAt(grid.positions)
          .cwiseProduct(VectorXd::Ones(lateral.size()) + 0.1 * VectorXd::Random(lateral.size()));
  const auto penalty = [&](const VectorXd& lengths, const Matrix3Xd& positions) {
    return computeStrainExcess(lateral, lengths, positions, 0.02, 3).penalty;
  };
  const StrainExcess excess = computeStrainExcess(lateral, rest, grid.positions, 0.02, 3);
  constexpr double kStep = 1e-7;
  for (Eigen::Index n = 0; n < rest.size(); ++n) {
    const VectorXd step = kStep * VectorXd::Unit(rest.size(), n);
    const double slope =
        (penalty(rest + step, grid.positions) - penalty(rest - step, grid.positions)) / (2 * kStep);
    EXPECT_NEAR(excess.byRest[n], slope, 1e-6);
  }
  for (Eigen::Index n = 0; n < grid.positions.size(); ++n) {
    Matrix3Xd above = grid.positions;
    above.data()[n] += kStep;
    Matrix3Xd below = grid.positions;
    below.data()[n] -= kStep;
    EXPECT_NEAR(excess.byPositions.data()[n],
                (penalty(rest, above) - penalty(rest, below)) / (2 * kStep), 1e-6);
  }
}

}  // namespace
}  // namespace morphgrid
