// The torso of tools/torso, fitted to Fig. 7.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "app/pipeline.h"
#include "surface/load_mesh.h"
#include "tests/support/folders.h"

namespace morphgrid {
namespace {

TEST(TorsoScene, MeasuresWhatThePaperPrints) {
  const RunRecord record = checkScene(loadScene(sourceFolder() / "scenes/torso.toml"));
  ASSERT_TRUE(record.measurement);
  EXPECT_NEAR(record.measurement->longestIsolineU, 62.81, 0.02 * 62.81);
  EXPECT_NEAR(record.measurement->longestIsolineV, 30.55, 0.02 * 30.55);
  EXPECT_NEAR(record.measurement->largestCurvature, 0.45, 0.02 * 0.45);
  EXPECT_EQ(record.grid.shape.verticesU - 1, 40);
  EXPECT_EQ(record.grid.shape.verticesV - 1, 20);
  EXPECT_EQ(record.grid.layerSpacing, 0.5);
}

TEST(TorsoScene, HasNeitherHolesNorOverhangs) {
  const RunRecord record = checkScene(loadScene(sourceFolder() / "scenes/torso.toml"));
  ASSERT_TRUE(record.mesh);
  EXPECT_EQ(record.mesh->missed, 0);
  EXPECT_LT(record.mesh->largestJump, 2);
}

TEST(TorsoScene, TheTorsoIsAClosedBodySeenFromOutside) {
  const TriangleMesh mesh = loadMesh(sourceFolder() / "scenes/meshes/torso.ply").mesh;
  std::vector<std::pair<int, int>> edges;
  double volume = 0;
  for (const auto& t : mesh.triangles.colwise()) {
    for (int corner = 0; corner < 3; ++corner) edges.emplace_back(t[corner], t[(corner + 1) % 3]);
    const Eigen::Matrix3d corners = mesh.vertices(Eigen::all, t);
    volume += corners.determinant() / 6;
  }
  std::sort(edges.begin(), edges.end());
  EXPECT_EQ(std::adjacent_find(edges.begin(), edges.end()), edges.end());
  const auto boundary = std::count_if(edges.begin(), edges.end(), [&](const auto& edge) {
    return !std::binary_search(edges.begin(), edges.end(), std::pair(edge.second, edge.first));
  });
  EXPECT_EQ(boundary, 0);
  EXPECT_GT(volume, 0);
}

}  // namespace
}  // namespace morphgrid
