#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "surface/load_mesh.h"
#include "surface/ray_hits.h"
#include "tests/support/shared_folder.h"

namespace morphgrid {
namespace {

struct SymmetricMesh {
  const char* file;
  double scale;
  SamplingBox box;  ///< Without holes.
};

class SharedMeshRays : public testing::TestWithParam<SymmetricMesh> {
 protected:
  void SetUp() override {
    const auto folder = sharedFolder();
    if (!folder) {
      GTEST_SKIP() << "there is no shared folder";
    }
    Eigen::Matrix3d turn;  // They look along z; rays come along x.
    turn << 0, 0, -1,      //
        0, 1, 0,           //
        1, 0, 0;
    mesh_ = transformed(Eigen::Affine3d(GetParam().scale * turn),
                        loadMesh(*folder / "meshes" / GetParam().file).mesh);
  }

  TriangleMesh mesh_;
};

TEST_P(SharedMeshRays, LoseNoneOnTheCentreLine) {
  const MeshRayCaster caster(mesh_);
  for (const int countV : {3, 11, 50, 51, 100, 101, 501}) {
    const RayHits hits = caster.cast(GetParam().box, 400, countV);
    EXPECT_TRUE(findHoles(hits).empty()) << countV;
  }
}

/// But for facets: quads are halved along diagonals that do not mirror.
TEST_P(SharedMeshRays, MirrorAsTheMeshDoes) {
  const RayHits hits = MeshRayCaster(mesh_).cast(GetParam().box, 101, 101);
  for (int j = 0; j <= 50; ++j) {
    for (int i = 0; i < 101; ++i) {
      EXPECT_NEAR(hits.points(0, hits.index(i, j)), hits.points(0, hits.index(i, 100 - j)),
                  0.01 * GetParam().box.uLength)
          << i << " " << j;
    }
  }
}

TEST_P(SharedMeshRays, FindABoxWithoutHoles) {
  const MeshRayCaster caster(mesh_);
  const auto box =
      suggestBox(caster, boundingBox(mesh_), 100, 100, std::numeric_limits<double>::infinity());
  ASSERT_TRUE(box);
  EXPECT_TRUE(findHoles(caster.cast(*box, 61, 61)).empty());
  const SamplingBox& known = GetParam().box;
  EXPECT_GE(box->uLength * box->vLength, 0.9 * known.uLength * known.vLength);
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, SharedMeshRays,
    testing::Values(SymmetricMesh{"mediapipe_canonical_face.obj", 1, {-6, -5.9, 12.5, 11.8}},
                    SymmetricMesh{"mh_male_head.obj", 10, {74, -5.4, 12, 10.8}},
                    SymmetricMesh{"mh_male_torso.obj", 10, {7, -12.5, 57, 25}}));

}  // namespace
}  // namespace morphgrid
