#include "measure/lattice_measurement.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "core/error.h"
#include "tests/measure/lattice_hits.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

constexpr SamplingBox kUnitBox{-0.5, -0.5, 1, 1};
constexpr double kNoCutoff = 1e300;

double paraboloid(double y, double z) { return (y * y + 0.5 * z * z) / 2; }
double saddle(double y, double z) { return (y * y - z * z) / 2; }
double hemisphere(double y, double z) { return -std::sqrt(1 - y * y - z * z); }

/// kappa of x = a y^2 / 2 at y.
double parabolaCurvature(double a, double y) { return a / std::pow(1 + a * a * y * y, 1.5); }

/// The largest |difference| of two fields.
double distance(const LateralField<double>& a, const LateralField<double>& b) {
  double largest = 0;
  for (std::size_t n = 0; n < a.allU().size(); ++n) {
    largest = std::max(largest, std::abs(a.allU()[n] - b.allU()[n]));
  }
  for (std::size_t n = 0; n < a.allV().size(); ++n) {
    largest = std::max(largest, std::abs(a.allV()[n] - b.allV()[n]));
  }
  return largest;
}

PointLattice moved(const Eigen::Affine3d& transform, PointLattice hits) {
  hits.points = transform * hits.points;
  return hits;
}

TEST(SurveyLattice, APlaneDoesNotBend) {
  const PointLattice hits = hitsOn([](double, double) { return 0.3; }, {1, 2, 3, 5}, 8, 6);
  const LatticeSurvey plane = surveyLattice(hits, 0);
  EXPECT_NEAR(plane.survey.longestIsolineU, 3, 1e-14);
  EXPECT_NEAR(plane.survey.longestIsolineV, 5, 1e-14);
  EXPECT_EQ(plane.survey.largestCurvature(), 0);
  EXPECT_EQ(plane.curvatureNoise, 0);
  const LatticeSurvey tilted =
      surveyLattice(hitsOn([](double y, double z) { return 0.3 * y - z; }, {1, 2, 3, 5}, 8, 6), 0);
  EXPECT_NEAR(tilted.survey.longestIsolineU, 3 * std::sqrt(1.09), 1e-14);
  EXPECT_LT(tilted.survey.largestCurvature(), 1e-13);
}

TEST(SurveyLattice, TakesTenSamplesASegment) {
  const LatticeSurvey mesh = surveyLattice(hitsOn(saddle, kUnitBox, 8, 6), 0);
  EXPECT_EQ(mesh.survey.sortedCurvatures.size(), 10u * (7 * 6 + 5 * 8));
  EXPECT_TRUE(
      std::is_sorted(mesh.survey.sortedCurvatures.begin(), mesh.survey.sortedCurvatures.end()));
  const LatticeSurvey smoothed = surveyLattice(hitsOn(saddle, kUnitBox, 8, 6), 0.1);
  EXPECT_EQ(smoothed.survey.sortedCurvatures.size(), 7u * 6 + 5 * 8);
}

TEST(SurveyLattice, KeepsTheDirectionsApart) {
  const SurfaceSurvey survey = surveyLattice(hitsOn(paraboloid, kUnitBox, 41, 41), 0).survey;
  EXPECT_NEAR(survey.largestCurvatureU, 1, 1e-3);
  EXPECT_NEAR(survey.largestCurvatureV, 0.5, 1e-3);
  EXPECT_EQ(survey.largestCurvature(), survey.largestCurvatureU);
}

TEST(SurveyLattice, IsolinesOfASphereConvergeAtSecondOrder) {
  // The longest run along the box's edges, on circles of this radius.
  const double radius = std::sqrt(0.75);
  const double exact = 2 * radius * std::asin(0.5 / radius);
  const auto error = [&](int count) {
    const SurfaceSurvey survey =
        surveyLattice(hitsOn(hemisphere, kUnitBox, count, count), 0).survey;
    EXPECT_NEAR(survey.longestIsolineU, survey.longestIsolineV, 1e-14);
    return exact - survey.longestIsolineU;
  };
  EXPECT_NEAR(std::log2(error(21) / error(41)), 2, 0.02);
}

TEST(SurveyLattice, CurvatureOfASphereConverges) {
  // Largest on the smallest circles, along the box's edges.
  const auto error = [](int count) {
    const SurfaceSurvey survey =
        surveyLattice(hitsOn(hemisphere, kUnitBox, count, count), 0).survey;
    return std::abs(survey.largestCurvature() - 1 / std::sqrt(0.75));
  };
  EXPECT_NEAR(std::log2(error(41) / error(81)), 1, 0.2);
  EXPECT_LT(error(81), 0.04);
}

TEST(SurveyLattice, NoiseIsTheStepFromSegmentToSegment) {
  // kappa = a y nearly, so that it steps by a h from one segment to the next. Two rays along v make
  // single segments, which have no neighbours.
  constexpr double kA = 1e-3;
  const PointLattice hits =
      hitsOn([](double y, double) { return kA * y * y * y / 6; }, kUnitBox, 21, 2);
  EXPECT_NEAR(surveyLattice(hits, 0).curvatureNoise, kA / 20, 1e-8);
}

TEST(SurveyLattice, TwoByTwoRaysWillDo) {
  const LatticeSurvey mesh = surveyLattice(hitsOn(saddle, {0, 0, 1, 1}, 2, 2), 0);
  EXPECT_LT(mesh.survey.largestCurvature(), 1e-15);
  EXPECT_EQ(mesh.curvatureNoise, 0);
  EXPECT_NEAR(mesh.survey.longestIsolineU, std::sqrt(1.25), 1e-15);
}

TEST(SurveyLattice, RefusesRaysThatRoundToOne) {
  const PointLattice hits = hitsOn([](double, double) { return 0.0; }, {1e9, 0, 1e-8, 1}, 4, 4);
  try {
    surveyLattice(hits, 0);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("coincide at (0, 1000000000, 0)"));
  }
}

TEST(MeasureLattice, GivesChordsTargetsAndCurvatureOfAParaboloid) {
  // The spline is exact on parabolas, ends included.
  const PointLattice hits = hitsOn(paraboloid, {-0.4, -1, 1.4, 2}, 8, 6);
  const SurfaceMeasurement m = measureLattice(hits, kNoCutoff, 0);
  ASSERT_EQ(m.nodesU, 7);
  ASSERT_EQ(m.nodesV, 5);
  EXPECT_EQ(m.points, hits.points);
  const auto mean = [](double a, double start, double length) {
    double sum = 0;
    for (int q = 0; q < 100; ++q) sum += parabolaCurvature(a, start + (q + 0.5) / 100 * length);
    return sum / 100;
  };
  for (int j = 0; j <= 5; ++j) {
    for (int i = 0; i < 7; ++i) {
      EXPECT_NEAR(m.curvatures.u(i, j), mean(1, -0.4 + 0.2 * i, 0.2), 1e-12);
      const auto chord = hits.points.col(hits.index(i + 1, j)) - hits.points.col(hits.index(i, j));
      EXPECT_NEAR(m.chords.u(i, j), chord.norm(), 1e-15);
    }
  }
  for (int j = 0; j < 5; ++j) {
    for (int i = 0; i <= 7; ++i) {
      EXPECT_NEAR(m.curvatures.v(i, j), mean(0.5, -1 + 0.4 * j, 0.4), 1e-12);
      const auto chord = hits.points.col(hits.index(i, j + 1)) - hits.points.col(hits.index(i, j));
      EXPECT_NEAR(m.chords.v(i, j), chord.norm(), 1e-15);
    }
  }
}

TEST(MeasureLattice, BendsTowardsTheNormalArePositive) {
  const SurfaceMeasurement m = measureLattice(hitsOn(saddle, kUnitBox, 9, 9), kNoCutoff, 0);
  for (int j = 0; j < 9; ++j) {
    for (int i = 0; i < 8; ++i) {
      EXPECT_GT(m.curvatures.u(i, j), 0.5);
      EXPECT_LT(m.curvatures.v(j, i), -0.5);
    }
  }
}

/// Isolines of a unit sphere run on circles. Errors of kappa along u, the largest of inner and of
/// end segments.
std::pair<double, double> errorsOnSphere(int count) {
  const PointLattice hits = hitsOn(hemisphere, kUnitBox, count, count);
  const SurfaceMeasurement m = measureLattice(hits, kNoCutoff, 0);
  double inner = 0;
  double ends = 0;
  for (int j = 0; j <= m.nodesV; ++j) {
    const double z = m.points(2, hits.index(0, j));
    for (int i = 0; i < m.nodesU; ++i) {
      double& largest = i > 0 && i < m.nodesU - 1 ? inner : ends;
      largest = std::max(largest, std::abs(m.curvatures.u(i, j) - 1 / std::sqrt(1 - z * z)));
    }
  }
  return {inner, ends};
}

TEST(MeasureLattice, CurvatureOfASphereConvergesAtItsOrder) {
  const auto [coarseInner, coarseEnds] = errorsOnSphere(31);
  const auto [fineInner, fineEnds] = errorsOnSphere(61);
  EXPECT_NEAR(std::log2(coarseInner / fineInner), 2, 0.2);
  EXPECT_NEAR(std::log2(coarseEnds / fineEnds), 1, 0.2);
}

TEST(MeasureLattice, CapsTheMeanOfAStrut) {
  // From kappa 1 at y = 0 down to 0.35 at y = 1: the mean is under a limit that samples are over.
  const PointLattice hits = hitsOn([](double y, double) { return y * y / 2; }, {0, 0, 2, 1}, 3, 2);
  const double mean = measureLattice(hits, kNoCutoff, 0).curvatures.u(0, 0);
  ASSERT_LT(mean, 0.9);
  EXPECT_EQ(measureLattice(hits, 0.9, 0).curvatures.u(0, 0), mean);
  EXPECT_EQ(measureLattice(hits, 0.5, 0).curvatures.u(0, 0), 0.5);
  const PointLattice other =
      hitsOn([](double y, double) { return -y * y / 2; }, {0, 0, 2, 1}, 3, 2);
  EXPECT_EQ(measureLattice(other, 0.5, 0).curvatures.u(0, 0), -0.5);
}

TEST(MeasureLattice, RigidMotionChangesNothing) {
  const auto bumps = [](double y, double z) { return std::sin(3 * y) * std::cos(2 * z); };
  const PointLattice hits = hitsOn(bumps, kUnitBox, 12, 9);
  const Eigen::Affine3d motion = Eigen::Translation3d(5, -3, 2) *
                                 Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -1).normalized());
  for (const double width : {0.0, 0.3}) {
    const SurfaceMeasurement before = measureLattice(hits, 2, width);
    const SurfaceMeasurement after = measureLattice(moved(motion, hits), 2, width);
    EXPECT_LT(distance(before.chords, after.chords), 1e-13);
    EXPECT_LT(distance(before.curvatures, after.curvatures), 1e-11);
  }
}

TEST(MeasureLattice, AMirrorTurnsTheSigns) {
  const PointLattice hits = hitsOn(saddle, {-0.3, -0.5, 1, 1}, 7, 9);
  SurfaceMeasurement m = measureLattice(hits, kNoCutoff, 0);
  const SurfaceMeasurement mirrored =
      measureLattice(moved(Eigen::Affine3d(Eigen::Scaling(-1.0, 1.0, 1.0)), hits), kNoCutoff, 0);
  for (int j = 0; j <= m.nodesV; ++j) {
    for (int i = 0; i < m.nodesU; ++i) {
      EXPECT_EQ(mirrored.curvatures.u(i, j), -m.curvatures.u(i, j));
    }
  }
}

TEST(LatticeMeasurement, ScalesWithTheScene) {
  constexpr double kScale = 4;  // A power of two: nothing rounds differently.
  const auto bumps = [](double y, double z) { return std::sin(3 * y) * std::cos(2 * z); };
  const PointLattice hits = hitsOn(bumps, kUnitBox, 12, 9);
  const PointLattice scaled = moved(Eigen::Affine3d(Eigen::Scaling(kScale)), hits);
  for (const double width : {0.0, 0.3}) {
    const LatticeSurvey survey = surveyLattice(hits, width);
    const LatticeSurvey scaledSurvey = surveyLattice(scaled, width * kScale);
    EXPECT_EQ(scaledSurvey.survey.longestIsolineV, survey.survey.longestIsolineV * kScale);
    EXPECT_EQ(scaledSurvey.curvatureNoise, survey.curvatureNoise / kScale);
    const SurfaceMeasurement m = measureLattice(hits, 2, width);
    const SurfaceMeasurement scaledM = measureLattice(scaled, 2 / kScale, width * kScale);
    EXPECT_EQ(scaledM.chords.u(3, 4), m.chords.u(3, 4) * kScale);
    EXPECT_EQ(scaledM.curvatures.u(3, 4), m.curvatures.u(3, 4) / kScale);
  }
}

TEST(Smoothing, LeavesConstantCurvatureAlone) {
  // So shallow that kappa is constant to 1e-8.
  const PointLattice hits =
      hitsOn([](double y, double z) { return 1e-4 * (y * y - 2 * z * z) / 2; }, kUnitBox, 30, 20);
  const SurfaceMeasurement rough = measureLattice(hits, kNoCutoff, 0);
  for (const double width : {1e-3, 0.2, 10.0}) {
    const SurfaceMeasurement smooth = measureLattice(hits, kNoCutoff, width);
    EXPECT_LT(distance(rough.curvatures, smooth.curvatures), 1e-11);
    EXPECT_EQ(distance(rough.chords, smooth.chords), 0);
  }
}

TEST(Smoothing, DampsAWaveAsAGaussianOfItsWidthDoes) {
  // kappa = -a w^2 cos(w y), shallow; a Gaussian of standard deviation sigma = width / 2 damps it
  // by exp(-sigma^2 w^2 / 2).
  constexpr double kFrequency = 2 * std::numbers::pi;
  constexpr double kWidth = 0.3;
  const PointLattice hits = hitsOn([](double y, double) { return 1e-5 * std::cos(kFrequency * y); },
                                   {-2, 0, 4, 1}, 401, 2);
  const SurfaceMeasurement rough = measureLattice(hits, kNoCutoff, 0);
  const SurfaceMeasurement smooth = measureLattice(hits, kNoCutoff, kWidth);
  const double damping = std::exp(-std::pow(kWidth / 2 * kFrequency, 2) / 2);
  for (int i = 100; i < 300; ++i) {  // More than three widths from the ends.
    EXPECT_NEAR(smooth.curvatures.u(i, 0), damping * rough.curvatures.u(i, 0), 1e-8);
  }
}

TEST(Smoothing, ANarrowWidthGivesTheMeanOfASegment) {
  const PointLattice hits = hitsOn(saddle, kUnitBox, 9, 7);
  EXPECT_LT(distance(measureLattice(hits, kNoCutoff, 1e-200).curvatures,
                     measureLattice(hits, kNoCutoff, 0).curvatures),
            1e-14);
}

TEST(Smoothing, AVastWidthSpreadsTheTurnOfAnIsolineOverItsLength) {
  // Chords grow with the slope, and the mean is over the length: kappa times it is the angle from
  // slope 0 to slope 2.
  const PointLattice hits =
      hitsOn([](double y, double) { return y * y / 2; }, {0, 0, 2, 1}, 101, 2);
  const double length = surveyLattice(hits, 0).survey.longestIsolineU;
  const SurfaceMeasurement m = measureLattice(hits, kNoCutoff, 1e6);
  EXPECT_NEAR(m.curvatures.u(0, 0) * length, std::atan(2), 1e-4);
  EXPECT_NEAR(m.curvatures.u(99, 1) * length, std::atan(2), 1e-4);
}

TEST(Smoothing, ComesBeforeTheCap) {
  // A crease's bend is spread, not cut off: the cap sees the smoothed curvature only.
  const auto crease = [](double y, double) { return std::abs(y); };
  const PointLattice hits = hitsOn(crease, kUnitBox, 21, 2);
  const double limit = surveyLattice(hits, 0.5).survey.largestCurvature();
  const SurfaceMeasurement capped = measureLattice(hits, limit, 0.5);
  const SurfaceMeasurement uncapped = measureLattice(hits, kNoCutoff, 0.5);
  EXPECT_LT(distance(capped.curvatures, uncapped.curvatures), 0.01 * limit);
  EXPECT_LT(limit, 0.2 * surveyLattice(hits, 0).survey.largestCurvature());
}

TEST(Smoothing, LowersTheNoiseOfARoughSurface) {
  std::mt19937 engine(1);
  const auto rough = [&](double y, double z) {
    return saddle(y, z) + 1e-3 * double(engine()) / double(std::mt19937::max());
  };
  const PointLattice hits = hitsOn(rough, kUnitBox, 50, 50);
  const LatticeSurvey before = surveyLattice(hits, 0);
  const LatticeSurvey after = surveyLattice(hits, 0.2);
  const LatticeSurvey exact = surveyLattice(hitsOn(saddle, kUnitBox, 50, 50), 0);
  EXPECT_GT(before.curvatureNoise, 20 * exact.curvatureNoise);
  EXPECT_LT(after.curvatureNoise, 0.05 * before.curvatureNoise);
  EXPECT_GT(before.survey.largestCurvature(), 4);
  EXPECT_LT(after.survey.largestCurvature(), 1.5);
}

}  // namespace
}  // namespace morphgrid
