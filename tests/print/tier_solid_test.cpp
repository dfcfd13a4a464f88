// The solid of a tier against what it should be: closed, and there where struts, hubs and tubes
// are.
#include "print/tier_solid.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <random>
#include <set>

#include "tests/print/print_samples.h"

namespace morphgrid {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

using Edges = std::map<std::pair<int, int>, int>;

Edges edgesOf(const SolidMesh& solid) {
  Edges edges;
  for (const auto& triangle : solid.triangles.colwise()) {
    for (int n = 0; n < 3; ++n) ++edges[{triangle[n], triangle[(n + 1) % 3]}];
  }
  return edges;
}

double volumeOf(const SolidMesh& solid) {
  double volume = 0;
  for (const auto& triangle : solid.triangles.colwise()) {
    const Vector3d a = solid.points.col(triangle[0]), b = solid.points.col(triangle[1]);
    volume += a.dot(b.cross(Vector3d(solid.points.col(triangle[2])))) / 6;
  }
  return volume;
}

double crossOf(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Triangles that lie flat at this height, seen from above.
struct FlatTriangle {
  Vector2d a, b, c;

  double area() const { return crossOf(b - a, c - a) / 2; }
  bool covers(const Vector2d& point) const {
    return crossOf(b - a, point - a) >= 0 && crossOf(c - b, point - b) >= 0 &&
           crossOf(a - c, point - c) >= 0;
  }
};

std::vector<FlatTriangle> flatTriangles(const SolidMesh& solid, double z) {
  std::vector<FlatTriangle> flat;
  for (const auto& triangle : solid.triangles.colwise()) {
    const auto corner = [&](int n) { return solid.points.col(triangle[n]); };
    const bool isThere = corner(0).z() == z && corner(1).z() == z && corner(2).z() == z;
    if (isThere) flat.push_back({corner(0).head<2>(), corner(1).head<2>(), corner(2).head<2>()});
  }
  return flat;
}

double areaOf(const std::vector<FlatTriangle>& triangles) {
  double area = 0;
  for (const FlatTriangle& triangle : triangles) area += triangle.area();
  return area;
}

double distanceToAxis(const PrintPlan& plan, const Strut& strut, const Vector2d& point) {
  const Vector2d from = plan.positions.col(strut.from);
  const Vector2d along = plan.positions.col(strut.to) - from;
  const double share = (point - from).dot(along) / along.squaredNorm();
  return share < 0 || share > 1 ? 1e9 : (from + share * along - point).norm();
}

enum class Place { nothing, strut, hub, border };

/// What lies at a point, by its distances; `border` within what polygons differ from circles.
Place placeOf(const PrintPlan& plan, const Vector2d& point) {
  const double reach = 0.02;
  double toHub = 1e9, toStrut = 1e9;
  for (int n = 0; n < plan.shape.layerVertexCount(); ++n) {
    toHub = std::min(toHub, (plan.positions.col(n) - point).norm());
  }
  forEachLateralStrut(plan.shape, [&](const Strut& strut) {
    if (strut.layer == 0) toStrut = std::min(toStrut, distanceToAxis(plan, strut, point));
  });
  const double hole = plan.hub.hole / 2, outer = plan.hub.diameter / 2;
  const double half = plan.strutWidth() / 2;
  if (std::abs(toHub - hole) < reach || std::abs(toHub - outer) < reach) return Place::border;
  if (toHub < outer) return toHub < hole ? Place::nothing : Place::hub;
  if (std::abs(toStrut - half) < reach) return Place::border;
  return toStrut < half ? Place::strut : Place::nothing;
}

class TierSolid : public testing::TestWithParam<GridShape> {
 protected:
  PrintPlan plan_ = planPrint("solid", randomGrid(GetParam(), 0, 0.3, 5), samplePrinter(),
                              sampleMaterial(), {.scale = 14, .enlargement = 1.0});
  SolidMesh top_ = tierSolid(plan_, plan_.shape.layers - 1);
  SolidMesh bottom_ = tierSolid(plan_, 0);  // With tubes.
  double strut_ = plan_.heights.strut;
  double tube_ = plan_.heights.strut + plan_.heights.tube;
};

TEST_P(TierSolid, IsClosed) {
  for (const SolidMesh& solid : {top_, bottom_}) {
    const Edges edges = edgesOf(solid);
    for (const auto& [edge, count] : edges) {
      ASSERT_EQ(count, 1);
      ASSERT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
  }
}

TEST_P(TierSolid, HasAHoleACellAndAHub) {
  const int holes = plan_.shape.layerCellCount() + plan_.shape.layerVertexCount();
  for (const SolidMesh& solid : {top_, bottom_}) {
    const auto edges = static_cast<Eigen::Index>(edgesOf(solid).size() / 2);
    EXPECT_EQ(solid.points.cols() - edges + solid.triangles.cols(), 2 - 2 * holes);
  }
}

TEST_P(TierSolid, VolumeIsAreaTimesHeight) {
  const double area = areaOf(flatTriangles(top_, strut_));
  EXPECT_NEAR(volumeOf(top_), area * strut_, 1e-9 * area);
  const double tubes = areaOf(flatTriangles(bottom_, tube_));
  EXPECT_NEAR(volumeOf(bottom_), area * strut_ + tubes * plan_.heights.tube, 1e-9 * area);
  // Circles with 24 sides and more, within and without, are so near round ones.
  const double ring =
      std::numbers::pi / 4 * (std::pow(plan_.hub.diameter, 2) - std::pow(plan_.hub.hole, 2));
  EXPECT_NEAR(tubes / plan_.shape.layerVertexCount() / ring, 1, 0.02);
}

TEST_P(TierSolid, LiesWhereStrutsAndHubsAre) {
  std::mt19937 generator(1);
  const Vector2d low = plan_.positions.rowwise().minCoeff().array() - 3;
  const Vector2d high = plan_.positions.rowwise().maxCoeff().array() + 3;
  std::uniform_real_distribution<double> x(low.x(), high.x()), y(low.y(), high.y());
  const auto struts = flatTriangles(bottom_, strut_), tubes = flatTriangles(bottom_, tube_);
  const auto countAt = [](const std::vector<FlatTriangle>& triangles, const Vector2d& point) {
    return std::count_if(triangles.begin(), triangles.end(),
                         [&](const FlatTriangle& triangle) { return triangle.covers(point); });
  };
  std::set<Place> met;
  for (int n = 0; n < 3000; ++n) {
    const Vector2d point(x(generator), y(generator));
    const Place place = placeOf(plan_, point);
    met.insert(place);
    if (place == Place::border) continue;
    EXPECT_EQ(countAt(struts, point), place == Place::strut ? 1 : 0) << point.transpose();
    EXPECT_EQ(countAt(tubes, point), place == Place::hub ? 1 : 0) << point.transpose();
  }
  EXPECT_EQ(met.size(), 4u);
}

TEST_P(TierSolid, LeavesRoomForPins) {
  const double hole = plan_.hub.hole / 2;
  for (const auto& point : bottom_.points.colwise()) {
    for (int n = 0; n < plan_.shape.layerVertexCount(); ++n) {
      EXPECT_GT((point.head<2>() - plan_.positions.col(n)).norm(), hole);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, TierSolid,
                         testing::Values(GridShape{2, 2, 2}, GridShape{4, 3, 3},
                                         GridShape{5, 6, 2}),
                         [](const auto& test) {
                           const GridShape& shape = test.param;
                           return std::to_string(shape.verticesU) + "x" +
                                  std::to_string(shape.verticesV) + "x" +
                                  std::to_string(shape.layers);
                         });

}  // namespace
}  // namespace morphgrid
