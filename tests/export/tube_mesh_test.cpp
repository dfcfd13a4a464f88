#include "export/tube_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <numbers>

#include "tests/export/export_samples.h"
#include "tests/support/strut_list.h"

namespace morphgrid {
namespace {

using Eigen::Vector3d;

const GridShape kTubeShape{4, 3, 2};

TEST(TubeMesh, TubesAreClosedAndHaveTheirVolume) {
  const ExportSample sample = exportSample(kTubeShape);
  const Eigen::Matrix3Xd vertices = tubeVertices(sample.grid, sample.positions);
  const Eigen::Matrix3Xi triangles = tubeTriangles(kTubeShape);
  const std::vector<Strut> struts = listStruts(kTubeShape);
  ASSERT_EQ(triangles.cols(), kTubeMeshTriangles * struts.size());
  std::map<std::pair<int, int>, int> edges;
  for (std::size_t tube = 0; tube < struts.size(); ++tube) {
    const Vector3d from = sample.positions.col(struts[tube].from);
    double volume = 0;
    for (const auto& corners :
         triangles.middleCols<kTubeMeshTriangles>(kTubeMeshTriangles * tube).colwise()) {
      const Vector3d a = vertices.col(corners[0]) - from;
      const Vector3d b = vertices.col(corners[1]) - from;
      volume += a.dot(b.cross(vertices.col(corners[2]) - from)) / 6;
      for (int n = 0; n < 3; ++n) ++edges[{corners[n], corners[(n + 1) % 3]}];
    }
    const double length = (sample.positions.col(struts[tube].to) - from).norm();
    const double radius = kTubeRadius * sample.grid.spacing;
    EXPECT_NEAR(volume, length * radius * radius * 1.5 * std::numbers::sqrt3, 1e-12) << tube;
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
}

TEST(TubeMesh, TubesTurnWithTheirStrutsAndHardlyAboutThem) {
  const ExportSample sample = exportSample(kTubeShape);
  const std::vector<Strut> struts = listStruts(kTubeShape);
  const Vector3d about = Vector3d(1, 2, 3).normalized();
  Eigen::Matrix3Xd before = tubeVertices(sample.grid, sample.positions);
  for (int step = 1; step <= 20; ++step) {
    const Eigen::Matrix3Xd turned =
        Eigen::AngleAxisd(0.1 * step, about).matrix() * sample.positions;
    const Eigen::Matrix3Xd after = tubeVertices(sample.grid, turned);
    for (Eigen::Index n = 0; n < after.cols(); ++n) {
      const Strut& strut = struts[n / kTubeMeshVertices];
      const int joint = n % kTubeMeshVertices < kTubeMeshSides ? strut.from : strut.to;
      const Vector3d spoke = after.col(n) - turned.col(joint);
      const Vector3d axis = (turned.col(strut.to) - turned.col(strut.from)).normalized();
      EXPECT_NEAR(spoke.norm(), kTubeRadius * sample.grid.spacing, 1e-9);
      EXPECT_NEAR(spoke.dot(axis), 0, 1e-9);
      const Vector3d was = Eigen::AngleAxisd(-0.1, about) * turned.col(joint);
      EXPECT_LT((spoke - (before.col(n) - was)).norm(), 0.3 * spoke.norm());
    }
    before = after;
  }
}

/// A strut may end where it began.
TEST(TubeMesh, StrutsOfNoLengthStayFinite) {
  ExportSample sample = exportSample({2, 2, 1});
  sample.positions.col(1) = sample.positions.col(0);
  EXPECT_TRUE(tubeVertices(sample.grid, sample.positions).allFinite());
}

}  // namespace
}  // namespace morphgrid
