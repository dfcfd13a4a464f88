#include "layout/conformal_sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "layout/coarse_sheet.h"
#include "layout/sheet_energy.h"
#include "layout/sheet_figures.h"
#include "tests/layout/sheets.h"

namespace morphgrid {
namespace {

using Eigen::Matrix2Xd;
using Eigen::VectorXd;

SheetFigures layOut(const SheetProblem& problem) {
  return computeSheetFigures(problem, layConformally(problem), 0.1);
}

TEST(ConformalSheet, OfAPlaneIsThePlaneItself) {
  const SheetFigures sheet = layOut(netOn(onSkewedPlane, 9, 7));
  EXPECT_LT(sheet.largestAngle, 1e-6);
  EXPECT_NEAR(sheet.scaleRatio, 1, 1e-6);
  EXPECT_EQ(sheet.strutsOutOfRange, 0);
}

// Where the surface rolls out, so do the angles in the tangent planes, but for the chords.
TEST(ConformalSheet, RollsACylinderOut) {
  const SheetFigures coarse = layOut(netOn(onCylinder, 9, 7));
  const SheetFigures fine = layOut(netOn(onCylinder, 17, 13));
  EXPECT_LT(coarse.largestAngle, 1e-4);
  EXPECT_NEAR(fine.scaleRatio, 1, 1e-4);
}

TEST(ConformalSheet, KeepsTheAnglesOfASphereTheBetterTheFinerTheNet) {
  const double coarse = layOut(netOn(onSphere, 11, 11)).meanAngle;
  const double fine = layOut(netOn(onSphere, 21, 21)).meanAngle;
  EXPECT_LT(coarse, 0.03);
  EXPECT_NEAR(fine / coarse, 0.5, 0.1);
}

// Which is conformal too, its scale all but the same along the rim.
TEST(ConformalSheet, BendsBarsAsLittleAsTheProjectionThatTheNetComesFrom) {
  const SheetProblem problem = netOn(onSphere, 11, 11);
  const SheetEnergy energy(problem);
  Matrix2Xd projected(2, problem.layer.layerVertexCount());
  forEachVertex(problem.layer, [&](const GridPlace& place) {
    projected.col(problem.layer.index(place)) << place.i, place.j;
  });
  projected *= energy.enlargement(projected);
  const double ofSheet = energy.evaluate(energy.unknownsAt(layConformally(problem).positions));
  EXPECT_LT(ofSheet, 1.02 * energy.evaluate(energy.unknownsAt(projected)));
}

TEST(ConformalSheet, TellsTheAngleErrorOfEachJoint) {
  const SheetProblem problem = netOn(onSphere, 11, 9);
  Sheet sheet = layConformally(problem);
  const VectorXd errors = printedAngleErrors(problem, sheet);
  const double largest = computeSheetFigures(problem, sheet, 0.1).largestAngle;
  ASSERT_EQ(errors.size(), 11 * 9);
  EXPECT_EQ(errors.maxCoeff(), largest);
  EXPECT_LT(errors.minCoeff(), largest);
  // A joint is moved: its own corners, and those of its neighbours at the bars to it, are off.
  const int joint = problem.layer.index(5, 4, 0);
  const double chord = (sheet.positions.col(joint + 1) - sheet.positions.col(joint)).norm();
  sheet.positions.col(joint) += 0.2 * chord * Eigen::Vector2d(1, 1);
  const VectorXd moved = printedAngleErrors(problem, sheet);
  for (const int neighbour : {joint, joint + 1, joint - 1, joint + 11, joint - 11}) {
    EXPECT_GT(moved[neighbour], 0.1);
  }
  EXPECT_EQ(moved[joint + 12], errors[joint + 12]);
}

TEST(ConformalSheet, StaysWithinTheRangeWhereItCan) {
  const SheetFigures sheet = layOut(netOn(onSphere, 15, 15, {0.1, 0.35}));
  EXPECT_EQ(sheet.strutsOutOfRange, 0);
  EXPECT_THAT(adviseOn(sheet, {0.1, 0.35}), testing::IsEmpty());
}

TEST(ConformalSheet, TellsWhatToChangeWhereItCannot) {
  const SheetFigures sheet = layOut(netOn(onSphere, 15, 15, {0.1, 0.12}));
  EXPECT_GT(sheet.strutsOutOfRange, 0.01 * sheet.lateralStruts);
  EXPECT_THAT(adviseOn(sheet, {0.1, 0.12}),
              testing::ElementsAre(testing::HasSubstr("grid.max_shrinkage")));
}

TEST(ConformalSheet, DoesNotDependOnTheUnitNorOnWhereTheTargetIs) {
  const SheetProblem problem = netOn(onSphere, 11, 9);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  SheetProblem moved = problem;
  moved.points = 1000 * (turn * problem.points);
  moved.normals = turn * problem.normals;
  const auto enlarged = [](double u, double v) -> Eigen::Vector3d { return 1000 * onSphere(u, v); };
  moved.rest = netOn(enlarged, 11, 9).rest;
  const SheetFigures here = layOut(problem);
  const SheetFigures there = layOut(moved);
  EXPECT_NEAR(there.meanAngle, here.meanAngle, 1e-6);
  EXPECT_NEAR(there.scaleRatio, here.scaleRatio, 1e-5);
  EXPECT_NEAR(there.sizeX, 1000 * here.sizeX, 1);
}

TEST(ConformalSheet, RefusesASheetThatOverlapsItself) {
  // More than a turn of a ramp, which rolls out to more than a turn of a ring.
  const auto ramp = [](double u, double v) -> Eigen::Vector3d {
    return {(1 + 0.4 * v) * std::cos(8 * u), (1 + 0.4 * v) * std::sin(8 * u), 0.2 * u};
  };
  EXPECT_THAT([&] { layConformally(netOn(ramp, 61, 4)); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("overlaps itself")));
}

TEST(ConformalSheet, StopsWhenNobodyWaits) {
  EXPECT_THROW(layConformally(netOn(onSphere, 11, 9), Cancellation([] { return true; })),
               Cancelled);
}

TEST(SheetEnergy, GradientIsThatOfFiniteDifferences) {
  const SheetProblem problem = netOn(onSphere, 4, 5, {0.1, 0.12});
  const SheetEnergy energy(problem);
  const Matrix2Xd flat = Matrix2Xd::Random(2, 20) * 0.05 + problem.points.topRows<2>();
  const VectorXd at = energy.unknownsAt(flat) + 0.05 * VectorXd::Random(60);
  const VectorXd gradient = energy.differentiate(at).gradient;
  constexpr double kStep = 1e-6;
  for (Eigen::Index n = 0; n < at.size(); ++n) {
    const VectorXd step = kStep * VectorXd::Unit(at.size(), n);
    const double slope = (energy.evaluate(at + step) - energy.evaluate(at - step)) / (4 * kStep);
    EXPECT_NEAR(gradient[n], slope, 1e-6 * (1 + std::abs(slope))) << n;
  }
}

TEST(CoarseSheetProblem, ProlongsCubicsExactlyFromUnevenLines) {
  const SheetProblem fine = netOn(onSphere, 24, 17);
  const CoarseSheetProblem coarse(fine, evenLines(fine.layer), 100);
  EXPECT_LE(coarse.problem().layer.layerVertexCount(), 110);
  const auto map = [](double u, double v) {
    return Eigen::Vector2d(u * u * u - v * v + 3, 0.1 * v * v * v + u * v);
  };
  const auto mapped = [&](const GridShape& layer, const NetLines& lines) {
    Matrix2Xd points(2, layer.layerVertexCount());
    forEachVertex(layer, [&](const GridPlace& place) {
      points.col(layer.index(place)) = map(lines.u[place.i], lines.v[place.j]);
    });
    return points;
  };
  const Matrix2Xd expected = mapped(fine.layer, evenLines(fine.layer));
  const Matrix2Xd prolonged = coarse.prolong(mapped(coarse.problem().layer, coarse.lines()));
  EXPECT_LT((prolonged - expected).cwiseAbs().maxCoeff(), 1e-8 * expected.cwiseAbs().maxCoeff());
}

TEST(CoarseSheetProblem, IsAsLongAsTheFineOne) {
  const SheetProblem fine = netOn(onCylinder, 24, 17);
  const CoarseSheetProblem coarse(fine, evenLines(fine.layer), 100);
  double fineLength = 0;
  for (int i = 0; i < fine.layer.cellsU(); ++i) fineLength += fine.rest[0].u(i, 0);
  double coarseLength = 0;
  for (int i = 0; i < coarse.problem().layer.cellsU(); ++i) {
    coarseLength += coarse.problem().rest[0].u(i, 0);
  }
  EXPECT_NEAR(coarseLength, fineLength, 1e-12);
}

// Too many joints to be laid out in one go.
TEST(ConformalSheet, OfALargeNetFitsAsThatOfASmallOne) {
  const SheetFigures small = layOut(netOn(onSphere, 31, 31, {0.1, 0.3}));
  const SheetFigures large = layOut(netOn(onSphere, 121, 121, {0.1, 0.3}));
  EXPECT_NEAR(large.meanAngle / small.meanAngle, 0.25, 0.05);
  EXPECT_EQ(large.strutsOutOfRange, 0);
  EXPECT_NEAR(large.sizeX, small.sizeX, 0.03 * small.sizeX);
}

}  // namespace
}  // namespace morphgrid
