// [design] of the scene file, from its keys to the design.
#include <gmock/gmock.h>

#include <cmath>

#include "app/design_scene.h"
#include "app/pipeline.h"
#include "tests/app/scene_files.h"
#include "tests/support/folders.h"

namespace morphgrid {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

RunRecord checkNamed(const char* scene, const std::vector<std::string>& overrides) {
  return checkScene(loadScene(sourceFolder() / "scenes" / scene, overrides));
}

TEST(DesignSettings, AreThePapersUnlessAskedFor) {
  const DesignRequest design = SceneFiles(kBezierScene).load().design;
  EXPECT_EQ(design.net, NetKind::isoline);
  EXPECT_EQ(design.reference, Reference::convex);
  EXPECT_FALSE(design.maxStrutRatio);
  EXPECT_EQ(design.compensateRounds, 0);
  EXPECT_EQ(design.optimiseSteps, 0);
  EXPECT_FALSE(design.enforceShrinkage);
}

TEST(DesignSettings, InverseDesignNeedsTheMethodThatItRunsOn) {
  const SceneFiles files(kBezierScene);
  const DesignRequest design =
      files.load({"design.compensate=2", "design.optimise=16", "design.enforce_shrinkage=true"})
          .design;
  EXPECT_EQ(design.compensateRounds, 2);
  EXPECT_EQ(design.optimiseSteps, 16);
  EXPECT_TRUE(design.enforceShrinkage);
  EXPECT_THAT(files.problems({"design.optimise=1", "solver.method=jacobi"}),
              HasSubstr("need solver.method = \"multigrid\""));
  EXPECT_THAT(files.problems({"design.compensate=1", "grid.layers=1"}),
              HasSubstr("need grid.layers >= 2"));
  EXPECT_THAT(files.problems({"design.optimise=-1"}),
              HasSubstr("design.optimise must be an integer >= 0 and <= 10000, got -1"));
}

TEST(DesignSettings, OneKeyAsksForTheTrueShape) {
  const SceneFiles files(kBezierScene);
  const Scene scene = files.load({"true_shape=true"});
  EXPECT_EQ(scene.material.model, Model::frame);
  EXPECT_EQ(scene.material.leastShrinkage, 0.02);
  EXPECT_EQ(scene.design.compensateRounds, 10);
  EXPECT_EQ(scene.design.optimiseSteps, 20);
  EXPECT_TRUE(scene.design.enforceShrinkage);
  EXPECT_EQ(scene.design.layout, Layout::conformal) << "what depends on these follows";
  const Scene other = files.load({"true_shape=true", "design.optimise=0", "material.model=bars",
                                  "design.enforce_shrinkage=false"});
  EXPECT_EQ(other.design.optimiseSteps, 0);
  EXPECT_EQ(other.design.compensateRounds, 10);
  EXPECT_EQ(other.material.model, Model::bars);
  EXPECT_FALSE(other.design.enforceShrinkage);
  EXPECT_THAT(SceneFiles(kBendAnglesScene).problems({"true_shape=true"}),
              HasSubstr("true_shape belongs to surfaces of kind \"bezier\" or \"mesh\""));
}

TEST(DesignSettings, TrueScenesAreWhatTheKeyMeans) {
  const Scene scene = loadScene(sourceFolder() / "scenes/iris_petal_true.toml");
  const Scene asked = loadScene(sourceFolder() / "scenes/iris_petal.toml",
                                {"true_shape=true", "grid.max_shrinkage=0.42"});
  EXPECT_EQ(scene.design, asked.design);
  EXPECT_EQ(scene.material, asked.material);
}

TEST(MaterialSettings, AreThePapersUnlessAskedFor) {
  const SceneFiles files(kBezierScene);
  EXPECT_EQ(files.load().material, MaterialRequest{});
  const MaterialRequest material =
      files
          .load({"material.model=frame", "material.bar_width=0.1", "material.bar_height=0.2",
                 "material.post_width=0.3", "material.joint_radius=0", "material.poisson=0"})
          .material;
  EXPECT_EQ(material, (MaterialRequest{Model::frame, 0.1, 0.2, 0.3, 0.0, 0.0}));
}

TEST(MaterialSettings, AFrameGoesWithWhatIsThereForIt) {
  const SceneFiles files(kBezierScene);
  const auto problems = [&](const char* with) {
    return files.problems({"material.model=frame", with});
  };
  EXPECT_THAT(problems("solver.method=jacobi"),
              HasSubstr("needs solver.method = \"multigrid\" or \"reference\", got \"jacobi\""));
  EXPECT_THAT(problems("grid.layers=1"), HasSubstr("needs grid.layers >= 2, got 1"));
  EXPECT_THAT(files.problems({"material.model=frame", "solver.smallest_eigenvalue=true",
                              "solver.method=reference"}),
              HasSubstr("needs solver.method = \"multigrid\""));
  EXPECT_THAT(problems("material.poisson=0.5"), HasSubstr("material.poisson must be"));
  EXPECT_THAT(problems("material.bar_width=0"),
              HasSubstr("material.bar_width must be a number >= 1e-30 and <= 1e+15"));
}

constexpr const char* kWeight =
    "layers = 2\n[material]\nmodel = \"frame\"\ngravity = [0, 0, -9.81]\ndensity = 1240\n"
    "modulus = 3e6\nsupports = [\"corners\", [2, 1, 0]]\n";

TEST(MaterialSettings, BarsWeighAndAreHeldAsAsked) {
  const MaterialRequest material = SceneFiles(kBezierScene + std::string(kWeight))
                                       .load({"material.fluid_density=1000", "material.unit=0.01"})
                                       .material;
  EXPECT_EQ(material.gravity, (std::array{0.0, 0.0, -9.81}));
  EXPECT_EQ(material.density, 1240);
  EXPECT_EQ(material.fluidDensity, 1000);
  EXPECT_EQ(material.modulus, 3e6);
  EXPECT_EQ(material.unit, 0.01);
  EXPECT_EQ(material.supports, (std::vector<Support>{SupportPlace::corners, std::array{2, 1, 0}}));
}

TEST(MaterialSettings, WeightNeedsWhatMakesItBend) {
  const SceneFiles files(kBezierScene + std::string(kWeight));
  EXPECT_EQ(files.problems(), "");
  EXPECT_EQ(files.problems({"material.model=paper"}),
            "scene.toml:9:11: material.gravity needs material.model = \"frame\": springs neither "
            "weigh nor are they held; set it or leave the key out\n"
            "scene.toml:12:12: material.supports needs material.model = \"frame\": springs neither "
            "weigh nor are they held; set it or leave the key out");
  EXPECT_EQ(SceneFiles(kBezierScene + std::string("layers = 2\n[material]\nmodel = \"frame\"\n"
                                                  "gravity = [0, 0, -9.81]\n"))
                .problems(),
            "scene.toml:9:11: material.gravity needs material.density, in kg/m^3\n"
            "scene.toml:9:11: material.gravity needs material.modulus, in Pa\n"
            "scene.toml:9:11: material.gravity needs material.supports: a grid that nothing holds "
            "falls freely, and weight does not bend it");
}

TEST(MaterialSettings, SupportsThatSlideCarryWhatFallsStraight) {
  const SceneFiles files(kBezierScene + std::string(kWeight));
  EXPECT_TRUE(files.load({"material.slide=true"}).material.slide);
  EXPECT_THAT(
      files.problems({"material.slide=true", "material.gravity=[1, 0, -9.81]"}),
      HasSubstr("material.slide needs material.gravity along z: else the grid slides away"));
  EXPECT_THAT(SceneFiles(kBezierScene).problems({"material.model=frame", "material.slide=true"}),
              HasSubstr("material.slide needs material.supports that slide"));
}

TEST(MaterialSettings, GravityIsAVectorAndSupportsAreJoints) {
  const SceneFiles files(kBezierScene + std::string(kWeight));
  EXPECT_THAT(files.problems({"material.gravity=9.81"}),
              HasSubstr("material.gravity must be an array of 3 numbers [x, y, z], m/s^2, got "
                        "9.81"));
  for (const auto& [value, got] : {std::pair{"[\"top\"]", "\"top\""},
                                   {"[[1, 2]]", "an array of 2"},
                                   {"[[1, 2, -3]]", "an array of 3"},
                                   {"[7]", "7"}}) {
    EXPECT_THAT(files.problems({std::string("material.supports=") + value}),
                HasSubstr(std::string("material.supports[0] must be \"middle\", \"corners\", "
                                      "\"rim\" or a joint [i, j, k] of integers >= 0, got ") +
                          got));
  }
  EXPECT_THAT(files.problems({"material.density=0"}), HasSubstr("material.density must be"));
}

TEST(MaterialSettings, TheRangeOfShrinkMustNotBeEmpty) {
  const SceneFiles files(kBezierScene);
  EXPECT_THAT(
      files.problems({"material.least_shrinkage=0.4", "grid.max_shrinkage=0.4"}),
      HasSubstr("material.least_shrinkage must be less than grid.max_shrinkage = 0.4, got 0.4"));
  EXPECT_EQ(files.load({"material.least_shrinkage=-0.1"}).material.leastShrinkage, -0.1);
}

TEST(DesignSettings, AFrameIsLaidOutConformally) {
  const SceneFiles files(kBezierScene);
  const Scene papers = files.load({});
  EXPECT_EQ(papers.design.layout, Layout::inPlane);
  EXPECT_EQ(papers.design.maxStrain, std::nullopt);
  const Scene frame = files.load({"material.model=frame"});
  EXPECT_EQ(frame.design.layout, Layout::conformal);
  EXPECT_EQ(frame.design.reference, Reference::middle);
  EXPECT_EQ(frame.design.maxStrain, 0.03);
  const Scene asked =
      files.load({"material.model=frame", "design.layout=in_plane", "design.max_strain=0.1"});
  EXPECT_EQ(asked.design.layout, Layout::inPlane);
  EXPECT_EQ(asked.design.reference, Reference::convex);
  EXPECT_EQ(asked.design.maxStrain, 0.1);
}

TEST(DesignSettings, AnOrthogonalNetGoesWithTheMiddle) {
  const SceneFiles files(kBezierScene);
  const DesignRequest design = files.load({"design.net=orthogonal"}).design;
  EXPECT_EQ(design.net, NetKind::orthogonal);
  EXPECT_EQ(design.reference, Reference::middle);
  EXPECT_EQ(files.load({"design.net=orthogonal", "design.reference=convex"}).design.reference,
            Reference::convex);
  EXPECT_EQ(files.load({"design.reference=middle"}).design.reference, Reference::middle);
  EXPECT_EQ(files.load({"design.max_strut_ratio=2.5"}).design.maxStrutRatio, 2.5);
}

TEST(DesignSettings, RefuseOtherValues) {
  const SceneFiles files(kBezierScene);
  EXPECT_THAT(
      files.problems({"design.net=square"}),
      HasSubstr(
          "design.net must be \"isoline\" or \"orthogonal\" or \"principal\", got \"square\""));
  EXPECT_THAT(files.problems({"design.reference=top"}),
              HasSubstr("design.reference must be \"convex\" or \"middle\", got \"top\""));
  EXPECT_THAT(files.problems({"design.max_strut_ratio=1"}),
              HasSubstr("design.max_strut_ratio must be a number > 1, got 1"));
}

TEST(DesignSettings, AreNotForBendAngles) {
  for (const char* key : {"net=isoline", "reference=convex", "max_strut_ratio=2", "optimise=1"}) {
    EXPECT_THAT(SceneFiles(kBendAnglesScene).problems({std::string("design.") + key}),
                HasSubstr("belongs to surfaces of kind \"bezier\" or \"mesh\""));
  }
}

TEST(PatchDesign, OfIsolinesTellsHowTheyRun) {
  const RunRecord record = checkNamed("patch.toml", {});
  ASSERT_TRUE(record.net);
  EXPECT_EQ(record.net->kind, NetKind::isoline);
  EXPECT_FALSE(record.net->modulus);
  EXPECT_EQ(record.net->blend, 0);
  EXPECT_GT(record.net->quality.meanAngleDeviation, 0.1);
}

TEST(PatchDesign, OnAnOrthogonalNetHasSquareNodes) {
  const SceneDesign designed =
      designScene(loadScene(sourceFolder() / "scenes/patch.toml", {"design.net=orthogonal"}));
  const GridDesign& design = designed.design;
  EXPECT_EQ(design.nodesU, 30);
  EXPECT_EQ(design.nodesV, 21);
  EXPECT_EQ(design.rest.size(), 3u);
  ASSERT_TRUE(designed.net);
  EXPECT_NEAR(*designed.net->modulus, 0.69963, 1e-4);
  EXPECT_LT(designed.net->quality.meanAngleDeviation, 0.02);
  EXPECT_THAT(designed.notices, IsEmpty());
  // The middle layer's rest lengths are the chords between the targets.
  const Eigen::Matrix3Xd& targets = *designed.targets;
  EXPECT_NEAR(design.rest[1].u(3, 2), (targets.col(2 * 31 + 4) - targets.col(2 * 31 + 3)).norm(),
              1e-12);
  EXPECT_GT(design.lengths.u(3, 2), design.rest[1].u(3, 2));
}

TEST(PatchDesign, BoundsTheStrutRatio) {
  const RunRecord free = checkNamed("iris_petal.toml", {"design.net=orthogonal"});
  EXPECT_GT(free.net->quality.strutRatio, 6);
  const RunRecord bound =
      checkNamed("iris_petal.toml", {"design.net=orthogonal", "design.max_strut_ratio=5"});
  EXPECT_LE(bound.net->quality.strutRatio, 5);
  EXPECT_GT(bound.net->quality.strutRatio, 4.99);
  EXPECT_GT(bound.net->blend, 0);
  EXPECT_LT(bound.net->blend, 1);
  EXPECT_GT(bound.net->quality.meanAngleDeviation, free.net->quality.meanAngleDeviation);
  EXPECT_THAT(bound.notices, IsEmpty());
}

TEST(PatchDesign, TellsWhereTheStrutRatioCannotBeBound) {
  EXPECT_THAT(checkNamed("iris_petal.toml", {"design.net=orthogonal", "design.max_strut_ratio=1.1"})
                  .notices,
              ElementsAre(HasSubstr("beyond design.max_strut_ratio = 1.1: no blend with the "
                                    "isolines does better")));
  EXPECT_THAT(checkNamed("iris_petal.toml", {"design.max_strut_ratio=1.1"}).notices,
              ElementsAre(HasSubstr("so the isolines run")));
}

TEST(PatchDesign, ThePapersReferenceGoesWithAnOrthogonalNetToo) {
  const SceneDesign designed =
      designScene(loadScene(sourceFolder() / "scenes/egg_chair.toml",
                            {"design.net=orthogonal", "design.reference=convex"}));
  // A deep shell that curves towards its normals everywhere: L0 is below, on the convex side.
  EXPECT_EQ(designed.design.rest[0].u(8, 10), designed.design.lengths.u(8, 10));
  EXPECT_GT(designed.design.bendAngles.u(8, 10), 0);
  EXPECT_GT(designed.design.bendAngles.v(8, 10), 0);
}

TEST(DesignSettings, CheckTellsTheSizeOfTheSheetThatIsPrinted) {
  const RunRecord record = checkNamed("egg_chair_print.toml", {});
  ASSERT_TRUE(record.printedSheetMm());
  const Eigen::Array2d inScene(record.sheet->sizeX, record.sheet->sizeY);
  EXPECT_TRUE(record.printedSheetMm()->isApprox(record.print->scale * inScene));
  EXPECT_GT(record.printedSheetMm()->maxCoeff(), 200);  // The largest that fits on 250 x 210.
  EXPECT_FALSE(checkNamed("egg_chair_true.toml", {}).printedSheetMm());
}

}  // namespace
}  // namespace morphgrid
