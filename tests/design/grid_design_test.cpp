#include "design/grid_design.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/error.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

SurfaceMeasurement uniformMeasurement(double length, double curvature) {
  SurfaceMeasurement m{2, 3, LateralField<double>(2, 3, length),
                       LateralField<double>(2, 3, curvature), Eigen::Matrix3Xd::Zero(3, 12)};
  return m;
}

TEST(DesignGrid, BendAngleIsThatOfTheChord) {
  const GridDesign design = designGrid(uniformMeasurement(0.8, -0.5), {.layerSpacing = 0.1}, 3);
  // A chord of length L on radius R spans 2 asin(L / 2R).
  EXPECT_NEAR(design.bendAngles.u(1, 2), -2 * std::asin(0.2), 1e-15);
  EXPECT_EQ(design.spacing, 0.8);
  EXPECT_TRUE(design.notices.empty());
}

TEST(DesignGrid, ClampsAStrutLongerThanItsDiameter) {
  const GridDesign design = designGrid(uniformMeasurement(3, 1), {.layerSpacing = 0.1}, 3);
  EXPECT_NEAR(design.bendAngles.v(0, 0), std::acos(-1.0), 1e-12);
  EXPECT_THAT(design.notices, testing::ElementsAre(HasSubstr("Eq. 24")));
}

TEST(DesignGrid, RefusesStrutsWithoutLength) {
  SurfaceMeasurement m = uniformMeasurement(1, 0);
  m.chords.u(1, 0) = 0;
  EXPECT_THROW(designGrid(m, {.layerSpacing = 0.1}, 3), InputError);
}

TEST(DesignGrid, RestsAtEveryLayersOwnLength) {
  const GridDesign design = designGrid(uniformMeasurement(0.8, -0.5), {.layerSpacing = 0.1}, 3);
  ASSERT_EQ(design.rest.size(), 3u);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(design.rest[k].u(1, 2), restLength(0.8, design.bendAngles.u(1, 2), 0.1, k, 3));
  }
  EXPECT_EQ(design.rest[2].v(0, 0), 0.8);  // Curves towards the bottom: convex on top.
  EXPECT_NEAR(largestBendShrink(design), 2 * 2 * 0.1 * 0.2 / 0.8, 1e-15);
}

/// A cylinder of radius R, three nodes around, two along its axis; normals point to the axis.
constexpr double kRadius = 2;
constexpr double kStep = 0.3;
struct Cylinder {
  SurfaceMeasurement measurement{3, 2,
                                 LateralField<double>(3, 2, 2 * kRadius * std::sin(kStep / 2)),
                                 LateralField<double>(3, 2), Eigen::Matrix3Xd(3, 12)};
  Eigen::Matrix3Xd normals{3, 12};

  Cylinder() {
    for (int n = 0; n < 12; ++n) {
      const double angle = kStep * (n % 4);
      normals.col(n) << -std::cos(angle), -std::sin(angle), 0;
      measurement.points.col(n) = -kRadius * normals.col(n);
      measurement.points(2, n) = n / 4;
    }
  }
};

TEST(DesignOnOffsets, StrutsOfACylinderAreChordsOfItsOffsets) {
  const Cylinder cylinder;
  for (const int layers : {2, 3, 4}) {
    const double tau = 0.2;
    const GridDesign design =
        designOnOffsets(cylinder.measurement, cylinder.normals, {layers, tau});
    ASSERT_EQ(design.rest.size(), std::size_t(layers));
    for (int k = 0; k < layers; ++k) {
      const double radius = kRadius - (k - (layers - 1) / 2.0) * tau;
      EXPECT_NEAR(design.rest[k].u(1, 1), 2 * radius * std::sin(kStep / 2), 1e-14);
      EXPECT_NEAR(design.rest[k].v(3, 0), 1, 1e-14);
    }
    EXPECT_EQ(design.lengths.u(2, 0), design.rest[0].u(2, 0));
    EXPECT_NEAR(design.bendAngles.u(2, 0), kStep, 1e-13);  // Towards the normals.
    EXPECT_NEAR(design.bendAngles.v(2, 0), 0, 1e-13);
    EXPECT_EQ(design.spacing, 1);
  }
}

TEST(DesignOnOffsets, TurnedOverTheTopIsConvex) {
  const Cylinder cylinder;
  const GridDesign design = designOnOffsets(cylinder.measurement, -cylinder.normals, {3, 0.2});
  EXPECT_NEAR(design.bendAngles.u(0, 0), -kStep, 1e-13);
  EXPECT_EQ(design.lengths.u(0, 0), design.rest[2].u(0, 0));
}

TEST(DesignOnOffsets, OneLayerDoesNotBend) {
  const Cylinder cylinder;
  const GridDesign design = designOnOffsets(cylinder.measurement, cylinder.normals, {1, 9});
  EXPECT_NEAR(design.rest[0].u(0, 0), 2 * kRadius * std::sin(kStep / 2), 1e-15);
  EXPECT_EQ(design.bendAngles.u(0, 0), 0);
}

TEST(DesignOnOffsets, RefusesLayersBeyondTheCentreOfCurvature) {
  const Cylinder cylinder;
  const auto design = [&](double tau) {
    return designOnOffsets(cylinder.measurement, cylinder.normals, {4, tau});
  };
  EXPECT_NO_THROW(design(kRadius / 1.5 - 1e-9));
  try {
    design(kRadius / 1.5 + 1e-9);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the u strut at node (0, 0), at (2, 0, 0)"));
    EXPECT_THAT(error.what(),
                HasSubstr("radius there is 2; grid.layer_spacing must be below 1.333"));
  }
}

TEST(DesignOnOffsets, RefusesStrutsWithoutLength) {
  Cylinder cylinder;
  cylinder.measurement.chords.v(1, 0) = 0;
  EXPECT_THROW(designOnOffsets(cylinder.measurement, cylinder.normals, {3, 0.1}), InputError);
}

TEST(RestLength, TheConvexSideKeepsItsLength) {
  const double theta = 0.4;
  const double step = 2 * 0.1 * std::sin(0.2);
  EXPECT_EQ(restLength(1, theta, 0.1, 0, 3), 1);
  EXPECT_NEAR(restLength(1, theta, 0.1, 2, 3), 1 - 2 * step, 1e-15);
  EXPECT_EQ(restLength(1, -theta, 0.1, 2, 3), 1);
  EXPECT_NEAR(restLength(1, -theta, 0.1, 0, 3), 1 - 2 * step, 1e-15);
  EXPECT_EQ(restLength(1, 0, 0.1, 1, 3), 1);
}

TEST(LengthsOnOffsets, DifferByMoreWhereBarsResist) {
  const Cylinder cylinder;
  const GridShape layer = cylinder.measurement.chords.shape();
  const auto lengths = [&](double barHeight) {
    return lengthsOnOffsets(layer, cylinder.measurement.points, cylinder.normals,
                            {3, 0.2, barHeight});
  };
  const auto springs = lengths(0);
  const auto bars = lengths(0.3);
  const double middle = springs[1].u(0, 0);
  EXPECT_NEAR(bars[1].u(0, 0), middle, 1e-15);
  // 3 0.3^2 / (12 (0.2^2 + 0.2^2))
  EXPECT_NEAR(bars[2].u(0, 0) - middle, 1.28125 * (springs[2].u(0, 0) - middle), 1e-12);
  EXPECT_NEAR(bars[0].v(0, 0), springs[0].v(0, 0), 1e-15);  // Straight along the axis.
}

TEST(CarryNormals, TurnWithThePoints) {
  const Cylinder cylinder;
  const GridShape layer = cylinder.measurement.chords.shape();
  const Eigen::Matrix3Xd& points = cylinder.measurement.points;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 2).normalized()).toRotationMatrix();
  const Eigen::Matrix3Xd carried = carryNormals(
      layer, points, cylinder.normals, (turn * points).colwise() + Eigen::Vector3d::Ones());
  EXPECT_LT((carried - turn * cylinder.normals).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(DesignFromBendAngles, RunsFromTheFirstToTheLastStrut) {
  const GridDesign design = designFromBendAngles({30, 3, 1, 1.0, -1.0, 0, 0}, 4, 0.15);
  EXPECT_EQ(design.bendAngles.u(0, 0), 1);
  EXPECT_NEAR(design.bendAngles.u(10, 3), 1 - 20.0 / 29, 1e-15);
  EXPECT_EQ(design.bendAngles.u(29, 3), -1);
  EXPECT_EQ(design.bendAngles.v(30, 2), 0);
  EXPECT_NEAR(largestBendShrink(design), 2 * 0.45 * std::sin(0.5), 1e-15);
}

TEST(DesignFromBendAngles, RefusesStrutsThatVanish) {
  EXPECT_THROW(designFromBendAngles({3, 3, 1, 1.0, -1.0, 0, 0}, 4, 0.5), InputError);
}

}  // namespace
}  // namespace morphgrid
