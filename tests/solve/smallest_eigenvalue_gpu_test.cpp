#include "solve/smallest_eigenvalue.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "energy/grid_energy.h"
#include "solve/frame_solver.h"
#include "solve/preconditioners.h"
#include "tests/solve/dense_eigenvalue.h"
#include "tests/solve/frame_grids.h"
#include "tests/solve/reference_problem.h"
#include "tests/solve/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

class SmallestEigenvalueByMultigrid : public DeviceTest {
 protected:
  SmallestEigenvalue compute(const StrutGrid& grid, const EigenvalueOptions& options) const {
    const DeviceGrid deviceGrid(device_, grid);
    return computeSmallestEigenvalue(grid, grid.positions,
                                     vCyclePreconditioner(device_, deviceGrid), options);
  }
};

TEST_F(SmallestEigenvalueByMultigrid, AgreesWithTheDenseOne) {
  const EigenvalueOptions options{.tolerance = 1e-5};
  for (const GridShape& shape : {GridShape{4, 5, 3}, GridShape{9, 7, 2}}) {
    const StrutGrid bent = atRest(bentGrid(shape, 8));
    EXPECT_NEAR(compute(bent, options).value / denseSmallestEigenvalue(bent, options.motions), 1,
                1e-5);
    const StrutGrid sheet = atRest(tightRimmedSheet(shape));
    EXPECT_NEAR(compute(sheet, options).value / denseSmallestEigenvalue(sheet, options.motions), 1,
                1e-5);
  }
  const EigenvalueOptions inPlane{.motions = Motions::inPlane, .tolerance = 1e-5};
  const StrutGrid flat = atRest(bentGrid({6, 4, 1}, 8));
  EXPECT_NEAR(compute(flat, inPlane).value / denseSmallestEigenvalue(flat, inPlane.motions), 1,
              1e-5);
}

/// Of a frame's exact Hessian over the mean stiffness, displacements in spacings; ascending.
Eigen::VectorXd denseEigenvalues(const StrutGrid& grid, const Equilibrium& rest) {
  Eigen::MatrixXd dense =
      FrameEnergy(grid).hessian(rest.positions, rest.rotations, FrameEnergy::Definiteness::exact);
  dense.triangularView<Eigen::StrictlyUpper>() = dense.transpose();
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(dense.rows());
  for (Eigen::Index n = 0; n < scale.size(); n += 6) scale.segment<3>(n).setConstant(grid.spacing);
  dense = scale.asDiagonal() * dense * scale.asDiagonal();
  dense /= GridEnergy(grid).meanStiffness() * grid.spacing * grid.spacing;
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

TEST_F(SmallestEigenvalueByMultigrid, OfAFrameAgreesWithTheDenseOne) {
  StrutGrid free = welded(bentGrid({4, 5, 3}, 8), {.width = 0.25, .height = 0.15, .joint = 0.05});
  free.spacing = 1.25;
  const StrutGrid held = weighedDown(free, {0, 0, -1e-4}, {7});
  const StrutGrid standing = weighedDown(free, {0, 0, -1e-4}, {0, 3, 16, 19}, true);
  for (const StrutGrid& grid : {free, held, standing}) {
    const Equilibrium rest = solveFrame(grid, {.tolerance = 1e-12});
    DeviceGrid deviceGrid(device_, grid);
    deviceGrid.uploadPositions(rest.positions, rest.rotations);
    const SmallestEigenvalue found =
        computeSmallestEigenvalue(grid, rest.positions, rest.rotations,
                                  vCyclePreconditioner(device_, deviceGrid), {.tolerance = 1e-4});
    EXPECT_TRUE(found.converged);
    const Eigen::VectorXd all = denseEigenvalues(grid, rest);
    const auto rigid = static_cast<Eigen::Index>(freeMotions(grid).size());
    EXPECT_LT(all.head(rigid).cwiseAbs().sum(), 1e-5 * all[rigid]);
    EXPECT_NEAR(found.value / all[rigid], 1, 1e-3);
  }
}

TEST_F(SmallestEigenvalueByMultigrid, GoesOnFromAMotionThatIsNear) {
  const StrutGrid grid = atRest(bentGrid({9, 7, 2}, 8));
  EigenvalueOptions options{.tolerance = 1e-3};
  const SmallestEigenvalue first = compute(grid, options);
  options.start = first.motion;
  const SmallestEigenvalue again = compute(grid, options);
  EXPECT_NEAR(again.value / first.value, 1, 1e-6);
  EXPECT_LT(again.iterations, first.iterations / 2);
}

TEST_F(SmallestEigenvalueByMultigrid, TakesFewIterations) {
  const StrutGrid grid = atRest(loadReferenceProblem("egg_chair").grid);
  const SmallestEigenvalue found = compute(grid, {});
  EXPECT_EQ(verdictOf(found), Verdict::minimum);
  EXPECT_LE(found.iterations, 10);
  const SmallestEigenvalue onHost = computeSmallestEigenvalue(
      grid, grid.positions, constantMatrixPreconditioner(grid), {.tolerance = 1e-3});
  EXPECT_NEAR(found.value / onHost.value, 1, 0.01);
}

}  // namespace
}  // namespace morphgrid
