#include "measure/catmull_rom.h"

#include <gtest/gtest.h>

#include <cmath>

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

const Vector3d kUp = Vector3d::UnitX();

/// Points (x(y), y, 0) at `count` equally spaced y from 0 to 1.
template <typename Function>
Matrix3Xd graph(Function x, int count) {
  Matrix3Xd points(3, count);
  for (int k = 0; k < count; ++k) {
    const double y = double(k) / (count - 1);
    points.col(k) << x(y), y, 0;
  }
  return points;
}

TEST(CatmullRomSpline, PassesThroughItsPoints) {
  const Matrix3Xd points = graph([](double y) { return std::exp(y); }, 6);
  const CatmullRomSpline spline(points);
  ASSERT_EQ(spline.segmentCount(), 5);
  for (int k = 0; k < 5; ++k) {
    EXPECT_LT((spline.point(k, 0) - points.col(k)).norm(), 1e-15);
    EXPECT_LT((spline.point(k, 1) - points.col(k + 1)).norm(), 1e-15);
  }
}

TEST(CatmullRomSpline, SegmentsMeetWithTheCentralTangent) {
  const Matrix3Xd points = graph([](double y) { return std::exp(y); }, 6);
  const CatmullRomSpline spline(points);
  for (int k = 1; k < 5; ++k) {
    const Vector3d central = (points.col(k + 1) - points.col(k - 1)) / 2;
    const auto before = spline.bezierSegment(k - 1);
    const auto after = spline.bezierSegment(k);
    EXPECT_LT((3 * (before.col(3) - before.col(2)) - central).norm(), 1e-14);
    EXPECT_LT((3 * (after.col(1) - after.col(0)) - central).norm(), 1e-14);
  }
}

TEST(CatmullRomSpline, IsExactOnAParabolaUpToItsEnds) {
  const CatmullRomSpline spline(graph([](double y) { return 2 * y * y; }, 5));
  for (int k = 0; k < 4; ++k) {
    for (const double t : {0.0, 0.3, 0.5, 1.0}) {
      const double y = (k + t) / 4;
      EXPECT_LT((spline.point(k, t) - Vector3d(2 * y * y, y, 0)).norm(), 1e-14);
      EXPECT_NEAR(spline.curvature(k, t, kUp), 4 / std::pow(1 + 16 * y * y, 1.5), 1e-12);
    }
  }
}

TEST(CatmullRomSpline, TheNormalSetsTheSign) {
  const CatmullRomSpline spline(graph([](double y) { return y * y; }, 4));
  const double curvature = spline.curvature(1, 0.5, kUp);
  EXPECT_GT(curvature, 0);
  EXPECT_EQ(spline.curvature(1, 0.5, -kUp), -curvature);
  EXPECT_EQ(spline.curvature(1, 0.5, Vector3d::Zero()), curvature);
}

TEST(CatmullRomSpline, TwoPointsGiveTheirChord) {
  const CatmullRomSpline spline((Matrix3Xd(3, 2) << 0, 2, 1, 1, 0, 4).finished());
  EXPECT_LT((spline.point(0, 0.25) - Vector3d(0.5, 1, 1)).norm(), 1e-15);
  EXPECT_EQ(spline.curvature(0, 0.25, kUp), 0);
}

TEST(CatmullRomSpline, StraightLinesDoNotBend) {
  const CatmullRomSpline spline(graph([](double) { return 0.7; }, 8));
  for (int k = 0; k < 7; ++k) {
    EXPECT_EQ(spline.curvature(k, 0.3, kUp), 0);
  }
}

TEST(CatmullRomSpline, PointsThatCoincideDoNotBend) {
  const CatmullRomSpline spline(Matrix3Xd::Constant(3, 4, 0.3));
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(spline.curvature(k, 0.5, kUp), 0);
  }
}

/// Errors of kappa on x = exp(y), the largest of inner segments and of the two at the ends.
struct CurvatureErrors {
  double sample = 0;  ///< Error of single samples in inner segments.
  double mean = 0;    ///< Error of means over inner segments.
  double endMean = 0;
};

double exactCurvature(double y) { return std::exp(y) / std::pow(1 + std::exp(2 * y), 1.5); }

CurvatureErrors errorsOfExponential(int segments) {
  constexpr int kSamples = 20;
  const CatmullRomSpline spline(graph([](double y) { return std::exp(y); }, segments + 1));
  CurvatureErrors errors;
  for (int k = 0; k < segments; ++k) {
    const bool inner = k > 0 && k < segments - 1;
    double sum = 0;
    for (int q = 0; q < kSamples; ++q) {
      const double t = (q + 0.5) / kSamples;
      const double error = spline.curvature(k, t, kUp) - exactCurvature((k + t) / segments);
      sum += error;
      if (inner) errors.sample = std::max(errors.sample, std::abs(error));
    }
    double& mean = inner ? errors.mean : errors.endMean;
    mean = std::max(mean, std::abs(sum) / kSamples);
  }
  return errors;
}

TEST(CatmullRomSpline, CurvatureConvergesAtItsOrder) {
  const CurvatureErrors coarse = errorsOfExponential(40);
  const CurvatureErrors fine = errorsOfExponential(80);
  EXPECT_NEAR(std::log2(coarse.mean / fine.mean), 2, 0.1);
  EXPECT_NEAR(std::log2(coarse.sample / fine.sample), 1, 0.1);
  EXPECT_NEAR(std::log2(coarse.endMean / fine.endMean), 1, 0.1);
}

TEST(CatmullRomSpline, PointsConvergeAtThirdOrder) {
  const auto largestError = [](int segments) {
    const CatmullRomSpline spline(graph([](double y) { return std::exp(y); }, segments + 1));
    double largest = 0;
    for (int k = 0; k < segments; ++k) {
      for (const double t : {0.25, 0.5, 0.75}) {
        const Vector3d point = spline.point(k, t);
        largest = std::max(largest, std::abs(point.x() - std::exp(point.y())));
      }
    }
    return largest;
  };
  EXPECT_NEAR(std::log2(largestError(40) / largestError(80)), 3, 0.1);
}

}  // namespace
}  // namespace morphgrid
