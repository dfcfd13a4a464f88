#include "surface/segment_clearance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace morphgrid {
namespace {

/// Segments with no ends in common, two columns each.
Eigen::VectorXd clearancesOf(const Eigen::Matrix3Xd& ends, double reach) {
  Matrix2Xi segments(2, ends.cols() / 2);
  for (int n = 0; n < segments.cols(); ++n) {
    segments.col(n) << 2 * n, 2 * n + 1;
  }
  return segmentClearances(ends, segments, reach);
}

Eigen::Matrix3Xd twoSegments(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  Eigen::Matrix3Xd ends(3, 4);
  ends << Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), a, b;
  return ends;
}

TEST(SegmentClearance, OfTwoSegments) {
  const struct {
    Eigen::Vector3d a, b;
    double distance;
  } cases[] = {
      {{0, 0.25, 0}, {1, 0.25, 0}, 0.25},                     // parallel
      {{3, 0.25, 0}, {1.5, 0.25, 0}, std::hypot(0.5, 0.25)},  // parallel, beyond the end
      {{0.5, -1, 0.5}, {0.5, 1, 0.5}, 0.5},                   // crossing
      {{0.5, 0.125, 0}, {0.5, 2, 7}, 0.125},                  // end to the middle
      {{1.5, 0.5, 0.5}, {3, 4, 5}, std::sqrt(0.75)},          // end to end
      {{0.5, -1, 0}, {0.5, 1, 0}, 0},                         // cutting
      {{2, 0, 0}, {1.25, 0, 0}, 0.25},                        // in one line
      {{0.5, 0.5, 0}, {0.5, 0.5, 0}, 0.5},                    // a point
  };
  for (const auto& [a, b, distance] : cases) {
    const Eigen::VectorXd clearances = clearancesOf(twoSegments(a, b), 1);
    EXPECT_NEAR(clearances[0], distance, 1e-12);
    EXPECT_NEAR(clearances[1], distance, 1e-12);
  }
}

TEST(SegmentClearance, BeyondReachIsInfinite) {
  const Eigen::Matrix3Xd ends = twoSegments({0, 0.25, 0}, {1, 0.25, 0});
  EXPECT_TRUE(std::isinf(clearancesOf(ends, 0.249)[0]));
  EXPECT_FALSE(std::isinf(clearancesOf(ends, 0.251)[0]));
}

TEST(SegmentClearance, NeighboursDoNotCount) {
  Eigen::Matrix3Xd points(3, 3);
  points << 0, 1, 0, 0, 0, 0.01, 0, 0, 0;
  Matrix2Xi segments(2, 2);
  segments << 0, 2, 1, 0;
  EXPECT_TRUE(segmentClearances(points, segments, 1).array().isInf().all());
}

/// In numbers of their own: matrices that are not optimised would take a minute here.
double bruteForce(const Eigen::Matrix3Xd& ends, int first, int second) {
  double closest = 1e18;
  for (int s = 0; s <= 100; ++s) {
    for (int t = 0; t <= 100; ++t) {
      double square = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const auto at = [&](int segment, int share) {
          const double* end = ends.data() + 6 * segment + axis;
          return end[0] + share / 100.0 * (end[3] - end[0]);
        };
        const double difference = at(first, s) - at(second, t);
        square += difference * difference;
      }
      closest = std::min(closest, square);
    }
  }
  return std::sqrt(closest);
}

TEST(SegmentClearance, ManySegmentsAgainstSampledOnes) {
  constexpr int kCount = 40;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(0, 1);
  Eigen::Matrix3Xd ends(3, 2 * kCount);
  for (double& value : ends.reshaped()) value = coordinate(random);
  const Eigen::VectorXd clearances = clearancesOf(ends, 10);
  for (int n = 0; n < kCount; ++n) {
    double expected = 1e9;
    for (int other = 0; other < kCount; ++other) {
      if (other != n) expected = std::min(expected, bruteForce(ends, n, other));
    }
    EXPECT_LE(clearances[n], expected + 1e-12);
    EXPECT_GE(clearances[n], expected - 0.015);  // Samples are 0.01 of a length apart.
  }
}

TEST(SegmentClearance, FarFromTheOrigin) {
  Eigen::Matrix3Xd ends = twoSegments({0, 0.25, 0}, {1, 0.25, 0});
  ends.colwise() += Eigen::Vector3d(1e5, -2e5, 3e5);
  EXPECT_NEAR(clearancesOf(ends, 0.26)[0], 0.25, 1e-9);
}

}  // namespace
}  // namespace morphgrid
