#include "measure/net.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "tests/measure/sample_lattices.h"

namespace morphgrid {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

/// The points of nets on the plane, stretched along v.
NetPoints onPlane(double stretch) {
  return [=](const Net& net) {
    PointLattice points{net.nodesU + 1, net.nodesV + 1,
                        Eigen::Matrix3Xd::Zero(3, net.parameters.cols())};
    points.points.row(0) = net.parameters.row(0);
    points.points.row(1) = stretch * net.parameters.row(1);
    return points;
  };
}

/// u = (i / nodesU)^power.
Net unevenNet(int nodes, double power) {
  Net net = isolineNet(nodes, nodes);
  net.parameters.row(0) = net.parameters.row(0).array().pow(power);
  return net;
}

double ratioOf(const Net& net, const NetPoints& pointsOf) {
  return assessNet(pointsOf(net)).strutRatio;
}

TEST(IsolineNet, IsEven) {
  const Net net = isolineNet(4, 2);
  EXPECT_EQ(net.parameters.cols(), 15);
  EXPECT_EQ(net.parameters.col(net.index(3, 1)), Eigen::Vector2d(0.75, 0.5));
  EXPECT_EQ(net.parameters.col(net.index(4, 2)), Eigen::Vector2d(1, 1));
}

TEST(RequireUnfolded, NamesTheNode) {
  Net net = isolineNet(4, 4);
  EXPECT_NO_THROW(requireUnfolded(net));
  net.parameters.col(net.index(2, 2)) << 0.2, 0.5;  // Beyond its neighbour at 0.25.
  try {
    requireUnfolded(net);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("node (1, 1), at u = 0.2, v = 0.5"));
  }
  net.parameters.col(net.index(2, 2)).setConstant(std::nan(""));
  EXPECT_THROW(requireUnfolded(net), InputError);
}

TEST(AssessNet, MeasuresAParallelogram) {
  const double angle = std::numbers::pi / 3;
  const NetQuality quality = assessNet(latticeOn(
      [&](double u, double v) -> Vector3d {
        return 3 * u * Vector3d::UnitX() + 4 * v * Vector3d(std::cos(angle), 0, std::sin(angle));
      },
      3, 5));  // Chords of 1.5 and 1.
  EXPECT_NEAR(quality.strutRatio, 1.5, 1e-14);
  EXPECT_NEAR(quality.meanAngleDeviation, std::numbers::pi / 6, 1e-14);
  EXPECT_NEAR(quality.largestAngleDeviation, std::numbers::pi / 6, 1e-14);
}

TEST(AssessNet, TellsTheLargestFromTheMean) {
  PointLattice square = latticeOn([](double u, double v) { return Vector3d(u, v, 0); }, 2, 2);
  square.points.col(3) << 2, 2, 0;  // Angles of 90, twice 90 + 26.565 and 36.87 degrees.
  const NetQuality quality = assessNet(square);
  const double tilt = std::atan(0.5);
  EXPECT_NEAR(quality.largestAngleDeviation, 2 * tilt, 1e-14);
  EXPECT_NEAR(quality.meanAngleDeviation, tilt, 1e-14);
}

TEST(BoundStrutRatio, LeavesANetWithinTheBoundAlone) {
  const Net net = unevenNet(5, 1.5);
  const BlendedNet bound = boundStrutRatio(net, ratioOf(net, onPlane(1)) + 1e-12, onPlane(1));
  EXPECT_EQ(bound.blend, 0);
  EXPECT_EQ(bound.net.parameters, net.parameters);
}

TEST(BoundStrutRatio, BlendsAsLittleAsItTakes) {
  const Net net = unevenNet(5, 2);  // Struts of 1 and 9 25ths.
  ASSERT_NEAR(ratioOf(net, onPlane(1)), 9, 1e-12);
  const BlendedNet bound = boundStrutRatio(net, 3, onPlane(1));
  // (9 - 4 s) / (1 + 4 s) = 3
  EXPECT_NEAR(bound.blend, 0.375, 1e-6);
  EXPECT_NEAR(ratioOf(bound.net, onPlane(1)), 3, 1e-4);
  EXPECT_LE(ratioOf(bound.net, onPlane(1)), 3);
  EXPECT_EQ(bound.net.parameters.col(5), Eigen::Vector2d(1, 0));
}

TEST(BoundStrutRatio, TakesTheSmallestWhereNoneWillDo) {
  const NetPoints pointsOf = onPlane(4);  // Even struts along v are four times those along u.
  EXPECT_EQ(boundStrutRatio(unevenNet(5, 2), 3, pointsOf).blend, 1);
  const Net even = isolineNet(5, 5);
  EXPECT_EQ(boundStrutRatio(even, 3, pointsOf).blend, 0);
}

}  // namespace
}  // namespace morphgrid
