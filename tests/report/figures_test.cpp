#include "report/figures.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "design/build_grids.h"
#include "target/patch_target.h"

namespace morphgrid {
namespace {

/// The plane z = 0 over the unit square.
class Plane : public Surface {
 public:
  Eigen::Vector3d point(double u, double v) const override { return {u, v, 0}; }
  Eigen::Vector3d normal(double, double) const override { return Eigen::Vector3d::UnitZ(); }
  Eigen::ArrayXd curvaturesAlongU(const Eigen::ArrayXd& u, double) const override { return 0 * u; }
  Eigen::ArrayXd curvaturesAlongV(double, const Eigen::ArrayXd& v) const override { return 0 * v; }
};

const ClosestPointQuery& plane() {
  static const ClosestPointQuery query = closestPointsOf(Plane());
  return query;
}

Eigen::Matrix3Xd planePoints(int count) {
  Eigen::Matrix3Xd points(3, count * count);
  for (int j = 0; j < count; ++j) {
    for (int i = 0; i < count; ++i) {
      points.col(j * count + i) = Eigen::Vector3d(i, j, 0) / (count - 1);
    }
  }
  return points;
}

TEST(TargetDistance, RigidMotionIsForgiven) {
  const Eigen::Matrix3Xd targets = planePoints(5);
  const Eigen::Isometry3d motion =
      Eigen::Translation3d(3, 4, 5) * Eigen::AngleAxisd(1.3, Eigen::Vector3d(1, 2, 3).normalized());
  const TargetDistance d = computeTargetDistance(motion * targets, targets, &plane());
  EXPECT_LT(d.maxPercent, 1e-12);
  EXPECT_LT(d.closest->maxPercent, 1e-12);
}

TEST(TargetDistance, ClosestPointForgivesSlidingInTheSurface) {
  const Eigen::Matrix3Xd targets = planePoints(5);
  Eigen::Matrix3Xd slid = targets;
  slid.col(12) += Eigen::Vector3d(0.05, -0.02, 0);  // the centre
  const TargetDistance d = computeTargetDistance(slid, targets, &plane());
  EXPECT_GT(d.rmsPercent, 0.5);
  EXPECT_LT(d.closest->rmsPercent, 0.2);
}

TEST(TargetDistance, IsInPercentOfTheDiagonal) {
  const Eigen::Matrix3Xd targets = planePoints(3);
  Eigen::Matrix3Xd bumped = targets;
  // +1, -1 in a pattern that no rigid motion can undo.
  for (int n = 0; n < 9; ++n) {
    bumped(2, n) = 0.01 * ((n % 3 == 1) != (n / 3 == 1) ? -1 : 1) * (n == 4 ? 0 : 1);
  }
  const TargetDistance d = computeTargetDistance(bumped, targets, &plane());
  EXPECT_NEAR(d.maxPercent, 100 * 0.01 / std::sqrt(2.0), 0.01);
  EXPECT_NEAR(d.rmsPercent, 100 * 0.01 * std::sqrt(8.0 / 9) / std::sqrt(2.0), 0.01);
}

TEST(TargetDistance, PercentsTurnWithTheTarget) {
  const Eigen::Matrix3Xd targets = planePoints(3);
  Eigen::Matrix3Xd slid = targets;
  slid(0, 4) += 0.1;
  const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d::UnitZ());  // Within the plane.
  const TargetDistance d = computeTargetDistance(slid, targets, &plane());
  const TargetDistance turned = computeTargetDistance(turn.toRotationMatrix() * slid,
                                                      turn.toRotationMatrix() * targets, &plane());
  EXPECT_NEAR(turned.rmsPercent, d.rmsPercent, 1e-9 * d.rmsPercent);
  EXPECT_NEAR(turned.diagonal, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(d.axisParallelDiagonal, std::sqrt(2.0), 1e-12);
  EXPECT_GT(turned.axisParallelDiagonal, 1.3 * std::sqrt(2.0));
}

TEST(TargetDistance, SpreadsAreOfTheSameDistances) {
  const Eigen::Matrix3Xd targets = planePoints(5);
  Eigen::Matrix3Xd slid = targets;
  slid.col(12) += Eigen::Vector3d(0.05, -0.02, 0.01);
  const TargetDistance d = computeTargetDistance(slid, targets, &plane());
  EXPECT_NEAR(10 * d.spread.binPercent, d.maxPercent, 1e-12);
  EXPECT_NEAR(10 * d.closest->spread.binPercent, d.closest->maxPercent, 1e-12);
  EXPECT_EQ(d.spread.counts[0], 24);
  EXPECT_EQ(d.spread.counts[9], 1);
  EXPECT_LT(d.spread.medianPercent, d.rmsPercent);
  EXPECT_EQ(d.closest->spread.percentile99, d.closest->maxPercent);
}

TEST(StrutErrors, VanishOnlyAtRest) {
  const GridDesign design = designFromBendAngles({3, 2, 1, 0.4, -0.4, 0, 0}, 2, 0.2);
  const Eigen::Matrix3Xd printed = inPlaneGrid(design, {}, Scaling::normalised).positions;
  const StrutGrid grid = stackedGrid(design, {}, Scaling::normalised, printed);
  const StrutErrors errors = computeStrutErrors(design, grid, grid.positions);
  EXPECT_NEAR(errors.l0Percent, 0, 1e-12);  // Flat, the L0 layers have their length,
  EXPECT_NEAR(errors.anglePercent, 0, 1e-12);
  // and the others are too long: by 2 tau sin(theta/2) / L_b along u (9 of 17 struts), 0 along v.
  const auto excess = [](double theta) {
    const double shrink = 2 * 0.2 * std::sin(theta / 2);
    return shrink / (1 - shrink);
  };
  EXPECT_NEAR(errors.lbPercent, 100 * 3 * (2 * excess(0.4) + 0) / 17, 1e-10);
}

}  // namespace
}  // namespace morphgrid
