#include <gtest/gtest.h>

#include "app/design_scene.h"
#include "tests/app/scene_files.h"

namespace morphgrid {
namespace {

class KeptDesign : public testing::TestWithParam<const char*> {
 protected:
  KeptDesign() {
    folder_.write("p.toml", kGoodPatch);
    folder_.write("scene.toml", GetParam());
  }

  std::shared_ptr<const SceneDesign> design(const std::vector<std::string>& overrides = {}) {
    const Scene scene = loadScene(folder_ / "scene.toml", overrides);
    return designs_.designOf(scene, targets_.targetOf(scene));
  }

  TemporaryFolder folder_;
  TargetKeeper targets_;
  DesignKeeper designs_;
};

TEST_P(KeptDesign, StaysWhileOtherKeysChange) {
  const auto first = design();
  for (const char* other : {"weights.angle=2", "solver.tolerance=1e-6", "solver.method=jacobi",
                            "solver.scaling=shapeop", "title=T"}) {
    EXPECT_EQ(design({other}), first) << other;
  }
}

TEST_P(KeptDesign, GoesWithTheKeysOfTheDesign) {
  auto before = design();
  for (const char* key : {"grid.layers=4", "grid.layer_spacing=0.05", "grid.max_shrinkage=0.3"}) {
    const auto next = design({key});
    EXPECT_NE(next, before) << key;
    before = next;
  }
  EXPECT_EQ(design({"grid.layers=5"})->design.layers, 5);
}

TEST_P(KeptDesign, StaysWhereAnotherCannotBeHad) {
  const auto first = design();
  Scene scene = loadScene(folder_ / "scene.toml", {"grid.layers=5"});
  scene.solve.isCancelled = [] { return true; };
  try {
    designs_.designOf(scene, targets_.targetOf(scene));
  } catch (const Cancelled&) {
    EXPECT_EQ(design(), first);
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, KeptDesign, testing::Values(kBezierScene, kBendAnglesScene));

TEST(DesignKeeper, DesignsAnewForAnotherTarget) {
  const SceneFiles files(kBezierScene);
  const Scene scene = files.load();
  DesignKeeper designs;
  const auto target = loadTarget(scene);
  const auto first = designs.designOf(scene, target);
  EXPECT_EQ(designs.designOf(scene, target), first);
  EXPECT_NE(designs.designOf(scene, loadTarget(scene)), first);
}

TEST(DesignKeeper, DesignsAnewForOtherBendAngles) {
  const SceneFiles files(kBendAnglesScene);
  DesignKeeper designs;
  const auto first = designs.designOf(files.load(), nullptr);
  const auto second = designs.designOf(files.load({"surface.theta_u=[0.1, 0.2]"}), nullptr);
  EXPECT_NE(second, first);
  EXPECT_GT(second->design.bendAngles.u(0, 0), 0);
}

}  // namespace
}  // namespace morphgrid
