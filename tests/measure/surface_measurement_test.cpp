#include "measure/surface_measurement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace morphgrid {
namespace {

/// A cylinder of radius R bent along u by `angle`, of length `length` along v; the normal points to
/// the axis, so that its curvature along u is +1/R.
class Cylinder : public Surface {
 public:
  Cylinder(double radius, double angle, double length)
      : radius_(radius), angle_(angle), length_(length) {}
  Eigen::Vector3d point(double u, double v) const override {
    return {radius_ * std::sin(u * angle_), length_ * v, -radius_ * std::cos(u * angle_)};
  }
  Eigen::Vector3d normal(double u, double) const override {
    return {-std::sin(u * angle_), 0, std::cos(u * angle_)};
  }
  Eigen::ArrayXd curvaturesAlongU(const Eigen::ArrayXd& u, double) const override {
    return Eigen::ArrayXd::Constant(u.size(), 1 / radius_);
  }
  Eigen::ArrayXd curvaturesAlongV(double, const Eigen::ArrayXd& v) const override { return 0 * v; }

 private:
  double radius_, angle_, length_;
};

TEST(SurveySurface, MeasuresACylinder) {
  const Cylinder cylinder(2, std::numbers::pi / 2, 5);
  const SurfaceSurvey survey = surveySurface(cylinder);
  EXPECT_NEAR(survey.longestIsolineU, std::numbers::pi, 1e-5);
  EXPECT_NEAR(survey.longestIsolineV, 5, 1e-12);
  EXPECT_EQ(survey.largestCurvatureU, 0.5);
  EXPECT_EQ(survey.largestCurvatureV, 0);
  EXPECT_EQ(survey.sortedCurvatures.size(), 2u * 100 * 1000);
}

TEST(CurvatureAtCutoff, TakesTheShareOfTheSortedSamples) {
  SurfaceSurvey survey{1, 1, 4, 4, {0, 1, 2, 3, 4}};
  EXPECT_EQ(curvatureAtCutoff(survey, 1), 4);
  EXPECT_EQ(curvatureAtCutoff(survey, 0.75), 3);
  EXPECT_EQ(curvatureAtCutoff(survey, 0.74), 2);
}

TEST(MeasureSurface, GivesChordsCurvatureAndTargets) {
  constexpr double kRadius = 2;
  constexpr double kSweep = 1.2;
  constexpr int kNodesU = 7;
  constexpr int kNodesV = 3;
  const Cylinder cylinder(kRadius, kSweep, 5);
  const SurfaceMeasurement m = measureSurface(cylinder, kNodesU, kNodesV, 10);
  const double chord = 2 * kRadius * std::sin(kSweep / kNodesU / 2);
  for (int j = 0; j <= kNodesV; ++j) {
    for (int i = 0; i < kNodesU; ++i) {
      EXPECT_NEAR(m.chords.u(i, j), chord, 1e-12);
      EXPECT_NEAR(m.curvatures.u(i, j), 0.5, 1e-12);
    }
  }
  EXPECT_NEAR(m.chords.v(7, 2), 5.0 / kNodesV, 1e-12);
  EXPECT_EQ(m.curvatures.v(0, 0), 0);
  EXPECT_LT((m.points.col(2 * (kNodesU + 1) + 3) - cylinder.point(3.0 / 7, 2.0 / 3)).norm(), 1e-15);
}

TEST(MeasureSurface, CapsTheCurvature) {
  const SurfaceMeasurement m = measureSurface(Cylinder(2, 1, 1), 3, 2, 0.25);
  EXPECT_NEAR(m.curvatures.u(1, 1), 0.25, 1e-12);
}

}  // namespace
}  // namespace morphgrid
