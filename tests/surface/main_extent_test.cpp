#include "surface/main_extent.h"

#include <gtest/gtest.h>

#include "surface/box_text.h"
#include "surface/ray_hits.h"
#include "tests/surface/sample_meshes.h"

namespace morphgrid {
namespace {

TriangleMesh sheet() {
  return heightField({0, 0, 2, 1}, 8, 8, [](double y, double z) { return 0.1 * y * z; });
}

TriangleMesh speckAt(const Eigen::Vector3d& place) {
  const TriangleMesh speck =
      heightField({0, 0, 0.01, 0.01}, 1, 1, [](double, double) { return 0; });
  return transformed(Eigen::Affine3d(Eigen::Translation3d(place)), speck);
}

TEST(MainExtent, IsTheWholeOfWhatHangsTogether) {
  EXPECT_TRUE(mainExtent(sheet()).isApprox(boundingBox(sheet())));
}

TEST(MainExtent, LeavesDebrisOutThatIsFarAway) {
  for (const Eigen::Vector3d& place :
       {Eigen::Vector3d(0, 900, 0), Eigen::Vector3d(0, 0, -50), Eigen::Vector3d(40, 1, 0.5)}) {
    const TriangleMesh mesh = joined(speckAt(place), sheet());
    EXPECT_TRUE(mainExtent(mesh).isApprox(boundingBox(sheet()))) << place.transpose();
  }
}

TEST(MainExtent, TakesWhatLiesNear) {
  const TriangleMesh mesh = joined(sheet(), speckAt({0, 2.5, 0.5}));
  EXPECT_NEAR(mainExtent(mesh).max().y(), 2.51, 1e-12);
}

TEST(MainExtent, TakesTheLargerOfTwo) {
  const TriangleMesh small =
      transformed(Eigen::Affine3d(Eigen::Translation3d(0, 30, 0) * Eigen::Scaling(0.5)), sheet());
  EXPECT_TRUE(mainExtent(joined(small, sheet())).isApprox(boundingBox(sheet())));
}

TEST(SurfaceArea, AddsTriangles) {
  EXPECT_NEAR(surfaceArea(heightField({0, 0, 2, 3}, 4, 5, [](double, double) { return 7; })), 6,
              1e-12);
}

TEST(BoxAsToml, HasTheDigitsThatRaysNeed) {
  EXPECT_EQ(boxAsToml({452308.27001, 5412343.51999, 3.96, 3.96}),
            "u_start = 452308.27\nv_start = 5412343.52\nu_length = 3.96\nv_length = 3.96");
  EXPECT_EQ(boxAsToml({-50, -31.25, 100, 62.5}),
            "u_start = -50\nv_start = -31.25\nu_length = 100\nv_length = 62.5");
}

TEST(SuggestBox, ClosesHolesThatMayBeFilled) {
  TriangleMesh mesh = heightField({0, 0, 1, 1}, 20, 20, [](double, double) { return 0; });
  Eigen::Index kept = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    if (t / 2 != 210) mesh.triangles.col(kept++) = mesh.triangles.col(t);  // A cell in the middle.
  }
  mesh.triangles.conservativeResize(3, kept);
  const MeshRayCaster caster(mesh);
  const auto open = suggestBox(caster, boundingBox(mesh), 50, 50, 20);
  const auto filled = suggestBox(caster, boundingBox(mesh), 50, 50, 20, 0.1);
  ASSERT_TRUE(open && filled);
  EXPECT_LT(open->uLength * open->vLength, 0.6);
  EXPECT_GT(filled->uLength * filled->vLength, 0.95);
}

TEST(SuggestBox, AvoidsASeamThatSomeGridFinds) {
  const auto flat = [](double, double) { return 0; };
  const TriangleMesh mesh = joined(heightField({0, 0, 0.4995, 1}, 4, 4, flat),
                                   heightField({0.5005, 0, 0.4995, 1}, 4, 4, flat));
  const MeshRayCaster caster(mesh);
  const auto box = suggestBox(caster, boundingBox(mesh), 100, 100, 20);
  ASSERT_TRUE(box);
  for (const int nodes : {10, 20, 30, 40, 160}) {
    EXPECT_TRUE(findHoles(caster.cast(*box, nodes + 1, nodes + 1)).empty()) << nodes;
  }
  EXPECT_GT(box->uLength, 0.45);
}

}  // namespace
}  // namespace morphgrid
