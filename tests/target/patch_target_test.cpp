#include "target/patch_target.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace morphgrid {
namespace {

/// x = 3 u, y = 3 v, z = 3 u (1 - u): its isolines along u are parabolas.
PatchRequest archRequest() {
  PatchRequest request;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      request.controlPoints[j][i] = {double(i), double(j), i == 1 || i == 2 ? 1.0 : 0.0};
    }
  }
  return request;
}

TEST(PatchTarget, IsSurveyedOnTheWay) {
  const PatchRequest request = archRequest();
  const SurfaceSurvey expected = surveySurface(BezierPatch(request.controlPoints));
  const auto target = makePatchTarget(request);
  EXPECT_EQ(target->survey().longestIsolineU, expected.longestIsolineU);
  EXPECT_EQ(target->survey().sortedCurvatures, expected.sortedCurvatures);
  EXPECT_FALSE(target->curvatureNoise());
  EXPECT_FALSE(target->meshSampling());
  EXPECT_FALSE(target->isOutdated());
}

TEST(PatchTarget, HasPointsAndNormalsAtAnyNet) {
  const auto target = makePatchTarget(archRequest());
  const auto sampler = target->sampler({});
  Net net = isolineNet(5, 3);
  net.parameters = net.parameters.array().square();
  net.followsIsolines = false;
  const PointLattice points = sampler->points(net);
  const Eigen::Matrix3Xd normals = sampler->normals(net);
  EXPECT_EQ(points.countU, 6);
  EXPECT_EQ(points.countV, 4);
  for (Eigen::Index n = 0; n < net.parameters.cols(); ++n) {
    const double u = net.parameters(0, n);
    const double v = net.parameters(1, n);
    EXPECT_LT((points.points.col(n) - Eigen::Vector3d(3 * u, 3 * v, 3 * u * (1 - u))).norm(),
              1e-14);
    EXPECT_LT((normals.col(n) - Eigen::Vector3d(2 * u - 1, 0, 1).normalized()).norm(), 1e-12);
  }
}

TEST(PatchTarget, MeasuresIsolinesByThePatchAndOtherLinesByTheirPoints) {
  const auto target = makePatchTarget(archRequest());
  const auto sampler = target->sampler({});
  const double limit = 1e9;
  const Net isolines = isolineNet(40, 4);
  Net others = isolines;
  others.followsIsolines = false;
  const PointLattice points = sampler->points(isolines);
  const SurfaceMeasurement exact = sampler->measure(isolines, points, limit);
  const SurfaceMeasurement splines = sampler->measure(others, points, limit);
  EXPECT_EQ(exact.points, splines.points);
  for (int i = 5; i < 35; ++i) {  // |kappa| = 2/3 / (1 + (1 - 2u)^2)^1.5, along the parabola.
    const double u = (i + 0.5) / 40;
    const double kappa = 2.0 / 3 / std::pow(1 + std::pow(1 - 2 * u, 2), 1.5);
    EXPECT_NEAR(std::abs(exact.curvatures.u(i, 2)), kappa, 1e-3 * kappa);
    EXPECT_NEAR(splines.curvatures.u(i, 2), exact.curvatures.u(i, 2), 0.01 * kappa);
    EXPECT_NE(splines.curvatures.u(i, 2), exact.curvatures.u(i, 2));
  }
}

TEST(PatchTarget, KnowsWhatIsClosest) {
  const auto target = makePatchTarget(archRequest());
  EXPECT_NEAR(target->closestPoints().distance({1.5, 1, 2}), 2 - 0.75, 1e-5);  // Over the crest.
  EXPECT_EQ(&target->closestPoints(), &target->closestPoints());
}

TEST(PatchTarget, AsksWhetherToGoOn) {
  EXPECT_THROW(makePatchTarget(archRequest(), Cancellation([] { return true; })), Cancelled);
}

TEST(PatchTarget, IsToldWithItsPlaceWhereItCannotBeHad) {
  PatchRequest request = archRequest();
  for (auto& row : request.controlPoints) row.fill({1, 2, 3});
  request.place = {"scene.toml", 3, 9};
  try {
    makePatchTarget(request);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("scene.toml:3:9: ", 0), 0u) << error.what();
  }
}

}  // namespace
}  // namespace morphgrid
