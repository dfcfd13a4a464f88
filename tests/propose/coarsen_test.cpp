#include "propose/coarsen.h"

#include <gtest/gtest.h>

#include "propose/sight.h"
#include "surface/main_extent.h"
#include "tests/propose/bowls.h"

namespace morphgrid {
namespace {

TEST(Coarsened, LeavesMeshesOfFewTrianglesAsTheyAre) {
  EXPECT_EQ(coarsened(bowl()).triangles, bowl().triangles);
}

TEST(Coarsened, LooksLikeWhatItStandsFor) {
  const TriangleMesh mesh = bowl(300);
  const TriangleMesh coarse = coarsened(mesh);
  EXPECT_LT(coarse.triangles.cols(), 0.6 * mesh.triangles.cols());
  EXPECT_NEAR(surfaceArea(coarse), surfaceArea(mesh), 0.03 * surfaceArea(mesh));
  const auto best = rateSights(coarse, listSights(coarse)).front();
  EXPECT_EQ(best.sight.name, "along -z");
  EXPECT_GT(best.share, 0.9);
}

}  // namespace
}  // namespace morphgrid
