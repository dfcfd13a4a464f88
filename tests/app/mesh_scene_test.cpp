#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/design_scene.h"
#include "app/pipeline.h"
#include "core/error.h"
#include "tests/support/height_field.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kBox = "u_start = -1\nv_start = -1\nu_length = 2\nv_length = 2\n";

/// Scene, mesh configuration and mesh in a folder of their own.
class MeshSceneFiles {
 public:
  explicit MeshSceneFiles(const std::string& obj, const std::string& surfaceKeys = kBox) {
    folder_.write("m.obj", obj);
    folder_.write("m.toml", "mesh = \"m.obj\"\nsamples_u = 21\nsamples_v = 21\n");
    scene_ = folder_.write("scene.toml", "[surface]\nkind = \"mesh\"\nmesh = \"m.toml\"\n" +
                                             surfaceKeys +
                                             "[grid]\nlayer_spacing = 0.05\nnodes_long = 8\n");
  }

  RunRecord check(const std::vector<std::string>& overrides = {}) const {
    return checkScene(scene(overrides));
  }
  SceneDesign design(const std::vector<std::string>& overrides = {}) const {
    return designScene(scene(overrides));
  }
  Scene scene(const std::vector<std::string>& overrides = {}) const {
    return loadScene(scene_, overrides);
  }

  std::string problems(const std::vector<std::string>& overrides = {}) const {
    try {
      check(overrides);
    } catch (const InputError& error) {
      return folder_.withoutPath(error.what());
    }
    return "";
  }

 private:
  TemporaryFolder folder_;
  std::filesystem::path scene_;
};

TEST(MeshScene, TellsWhatItsMeshLacks) {
  const MeshSceneFiles files(heightFieldObj(dome) + "f 1 2\n");
  EXPECT_THAT(files.check().notices,
              testing::Contains(HasSubstr("m.obj: passed over 1 face of fewer than three")));
}

TEST(MeshScene, TakesAMeshThatStandsForItsConfigurationAsItIs) {
  const MeshSceneFiles files(heightFieldObj(dome));
  EXPECT_THAT(files.problems(), "");
  EXPECT_THAT(files.problems({"surface.mesh=m.obj"}), "");
}

TEST(MeshScene, DesignsAGridOnTheMesh) {
  const MeshSceneFiles files(heightFieldObj(dome));
  const SceneDesign designed = files.design();
  EXPECT_EQ(designed.design.nodesU, 8);
  EXPECT_EQ(designed.design.nodesV, 8);
  ASSERT_TRUE(designed.targets);
  for (const auto& point : designed.targets->colwise()) {
    EXPECT_NEAR(point.x(), dome(point.y(), point.z()), 0.002);  // The mesh's chords.
  }
  for (const double theta : designed.design.bendAngles.allU()) {
    EXPECT_GT(theta, 0);  // It curves towards +x, the normal of (u, v) = (y, z).
  }
}

TEST(MeshScene, DesignsAnOrthogonalGridOnTheMesh) {
  // Turned by 45 degrees, the isolines of the saddle cross at other angles than 90.
  const auto saddle = [](double y, double z) { return 0.4 * y * z; };
  const MeshSceneFiles files(heightFieldObj(saddle));
  const SceneDesign designed = files.design({"design.net=orthogonal"});
  ASSERT_TRUE(designed.net);
  EXPECT_NEAR(*designed.net->modulus, 1, 1e-3);
  EXPECT_LT(designed.net->quality.meanAngleDeviation,
            0.5 * files.design().net->quality.meanAngleDeviation);
  for (const auto& point : designed.targets->colwise()) {
    EXPECT_NEAR(point.x(), saddle(point.y(), point.z()), 0.002);
  }
  EXPECT_EQ(designed.targets->col(8), (*files.design().targets).col(8));  // A corner.
}

TEST(MeshScene, TheMiddleReferenceLooksAlongTheMeshesNormals) {
  const MeshSceneFiles files(heightFieldObj(dome));
  const GridDesign middle = files.design({"design.reference=middle"}).design;
  const GridDesign convex = files.design().design;
  // kappa = 0.4 along y in the middle of the box.
  const double bend = 2 * std::asin(convex.lengths.u(4, 4) * 0.4 / 2);
  EXPECT_NEAR(middle.bendAngles.u(4, 4), bend, 0.1 * bend);
  EXPECT_EQ(middle.rest[0].u(4, 4), middle.lengths.u(4, 4));  // Curves towards the top.
}

TEST(MeshScene, HolesBetweenTheSampledRaysStopANetUnlessFilled) {
  // One cell is missing; the lattice of 21 x 21 rays meets its rim only.
  const MeshSceneFiles files(heightFieldObj(
      dome, [](double y, double z) { return std::abs(y - 0.25) + std::abs(z - 0.25) < 0.01; }));
  const Eigen::Vector2d inHole(0.62, 0.63);
  const Net net{1, 1, inHole.replicate(1, 4)};
  const auto open = loadTarget(files.scene());
  try {
    open->sampler({})->points(net);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("misses"), HasSubstr("at u 0.24, v 0.26"),
                                    HasSubstr("surface.fill_holes")));
  }
  const auto filled = loadTarget(files.scene({"surface.fill_holes=0.5"}));
  EXPECT_NEAR(filled->sampler({})->points(net).points(0, 0), dome(0.24, 0.26), 0.002);
  EXPECT_NO_THROW(files.check({"surface.fill_holes=0.5", "design.net=orthogonal"}));
}

TEST(MeshScene, RecordsHowRaysSampledIt) {
  const RunRecord record = MeshSceneFiles(heightFieldObj(dome)).check();
  ASSERT_TRUE(record.mesh);
  EXPECT_EQ(record.mesh->triangles, 800);
  EXPECT_EQ(record.mesh->rays, 21 * 21 + 9 * 9);
  EXPECT_EQ(record.mesh->missed, 0);
  EXPECT_NEAR(record.mesh->largestJump, 0.38, 1e-9);  // Between y = 0.9 and 1.
  ASSERT_TRUE(record.mesh->suggestedBox);
  EXPECT_GT(record.mesh->suggestedBox->uLength, 1.9);
  ASSERT_TRUE(record.measurement->curvatureNoise);
  EXPECT_FALSE(record.measurement->cutoffs.empty());
}

TEST(MeshScene, WithoutABoxSuggestsOne) {
  EXPECT_THAT(
      MeshSceneFiles(heightFieldObj(dome), "").problems(),
      AllOf(
          StartsWith("scene.toml:1:1: surface.u_start, v_start, u_length and v_length are missing"),
          HasSubstr("the mesh spans u -1 to 1, v -1 to 1"),
          HasSubstr("a box without holes:\nu_start = -0.99")));
}

TEST(MeshScene, APartOfABoxIsNotEnough) {
  EXPECT_EQ(
      MeshSceneFiles(heightFieldObj(dome), "u_start = -1\nu_length = 2\nv_length = 2\n").problems(),
      "scene.toml:1:1: surface.v_start is missing: it must be a number >= -1e+15 and <= 1e+15");
}

TEST(MeshScene, HolesStopTheRunUnlessFilled) {
  const std::string holed =
      heightFieldObj(dome, [](double y, double z) { return y > 0 && y < 0.4 && z > 0 && z < 0.3; });
  EXPECT_THAT(
      MeshSceneFiles(holed).problems(),
      AllOf(StartsWith("scene.toml:4:11: "), HasSubstr("miss "), HasSubstr("1 hole"),
            HasSubstr("surface.fill_holes"), HasSubstr("a box without holes:\nu_start = ")));
  const RunRecord record = MeshSceneFiles(holed, std::string(kBox) + "fill_holes = 0.5\n").check();
  EXPECT_GT(record.mesh->missed, 0);
}

TEST(MeshScene, RaysBesideTheMeshStopTheRun) {
  EXPECT_THAT(
      MeshSceneFiles(heightFieldObj(dome),
                     "u_start = 0\nv_start = -1\nu_length = 2\nv_length = 2\nfill_holes = 9\n")
          .problems(),
      HasSubstr("miss "));
}

TEST(MeshScene, OverhangsStopTheRunUnlessAllowed) {
  const std::string cliff = heightFieldObj([](double y, double) { return y > 0.05 ? 5.0 : 0.0; });
  EXPECT_THAT(
      MeshSceneFiles(cliff).problems(),
      AllOf(HasSubstr("steeper than surface.steepest_slope = 20"), HasSubstr("u 0.05, v ")));
  const RunRecord allowed =
      MeshSceneFiles(cliff).check({"surface.steepest_slope=60", "grid.curvature_cutoff=0.5"});
  EXPECT_NEAR(allowed.mesh->largestJump, 50, 1e-9);
}

TEST(MeshScene, SmoothingLowersTheNoise) {
  const std::string rough = heightFieldObj(
      [](double y, double z) { return dome(y, z) + 0.002 * std::sin(40 * y) * std::sin(37 * z); });
  const auto noise = [&](const char* keys) {
    return *MeshSceneFiles(rough, std::string(kBox) + keys).check().measurement->curvatureNoise;
  };
  EXPECT_LT(noise("smoothing_width = 0.5\n"), 0.3 * noise(""));
}

TEST(MeshScene, ABrokenMeshIsToldWithItsFile) {
  EXPECT_THAT(MeshSceneFiles("v 0 0 0\nf 1 2 3\n").problems(), HasSubstr("m.obj"));
}

}  // namespace
}  // namespace morphgrid
