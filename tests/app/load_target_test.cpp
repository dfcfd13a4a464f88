#include "app/load_target.h"

#include <gtest/gtest.h>

#include "tests/app/scene_files.h"
#include "tests/support/height_field.h"

namespace morphgrid {
namespace {

class KeptTarget : public testing::Test {
 protected:
  KeptTarget() {
    folder_.write("m.obj", heightFieldObj(dome));
    folder_.write("m.toml", kConfiguration);
    folder_.write("p.toml", kGoodPatch);
    folder_.write("scene.toml",
                  "[surface]\nkind = \"mesh\"\nmesh = \"m.toml\"\nu_start = -0.9\nv_start = -0.9\n"
                  "u_length = 1.8\nv_length = 1.8\n[grid]\nlayer_spacing = 0.05\n");
  }

  std::shared_ptr<const Target> target(const std::vector<std::string>& overrides = {}) {
    return keeper_.targetOf(loadScene(folder_ / "scene.toml", overrides));
  }

  static constexpr const char* kConfiguration = "mesh = \"m.obj\"\nsamples_u = 21\n";
  TemporaryFolder folder_;
  TargetKeeper keeper_;
};

TEST_F(KeptTarget, StaysWhileOtherKeysChange) {
  const auto first = target();
  for (const char* other : {"solver.tolerance=1e-6", "grid.layer_spacing=0.1", "grid.nodes_long=4",
                            "design.net=orthogonal", "weights.angle=2", "title=T"}) {
    EXPECT_EQ(target({other}), first) << other;
  }
}

TEST_F(KeptTarget, GoesWithTheKeysThatDefineIt) {
  auto before = target();
  for (const char* key : {"surface.u_start=-0.8", "surface.fill_holes=0.1",
                          "surface.steepest_slope=30", "surface.smoothing_width=0.1"}) {
    const auto next = target({"surface.u_length=1.5", key});
    EXPECT_NE(next, before) << key;
    before = next;
  }
}

TEST_F(KeptTarget, GoesWithItsConfiguration) {
  const auto first = target();
  folder_.write("m.toml", std::string(kConfiguration) + "subdivisions = 1\n");
  const auto second = target();
  EXPECT_NE(second, first);
  EXPECT_EQ(second->meshSampling()->mesh.triangles.cols(), 3200);
}

TEST_F(KeptTarget, GoesWithItsMesh) {
  const auto first = target();
  const auto time = std::filesystem::last_write_time(folder_ / "m.obj");
  folder_.write("m.obj", heightFieldObj([](double, double) { return 0.0; }));
  std::filesystem::last_write_time(folder_ / "m.obj", time + std::chrono::seconds(1));
  EXPECT_NE(target(), first);
  EXPECT_EQ(target()->survey().largestCurvature(), 0);
}

TEST_F(KeptTarget, StaysWhereAnotherCannotBeHad) {
  const auto first = target();
  EXPECT_THROW(target({"surface.u_start=0"}), InputError);
  EXPECT_EQ(target(), first);
}

TEST_F(KeptTarget, OfAPatchGoesWithItsPoints) {
  const auto patch = [&](const std::string& points) {
    folder_.write("p.toml", points);
    return keeper_.targetOf(loadScene(folder_.write("patch.toml", kBezierScene)));
  };
  const auto first = patch(kGoodPatch);
  EXPECT_EQ(patch(kGoodPatch), first);
  std::string other = kGoodPatch;
  other.replace(other.find("0.5]"), 3, "0.6");
  EXPECT_NE(patch(other), first);
}

TEST(LoadTarget, OfBendAnglesIsNone) {
  EXPECT_EQ(loadTarget(SceneFiles(kBendAnglesScene).load()), nullptr);
}

TEST(LoadTarget, LoadingASceneTouchesNoMesh) {
  const TemporaryFolder folder;
  folder.write("m.obj", "no mesh");
  folder.write("m.toml", "mesh = \"m.obj\"\n");
  const Scene scene = loadScene(folder.write(
      "scene.toml", "[surface]\nkind = \"mesh\"\nmesh = \"m.toml\"\n[grid]\nlayer_spacing = 1\n"));
  EXPECT_FALSE(std::get<MeshRequest>(scene.surface).box);
  EXPECT_THROW(loadTarget(scene), InputError);
}

}  // namespace
}  // namespace morphgrid
