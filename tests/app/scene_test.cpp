#include "app/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>
#include <set>

#include "app/design_scene.h"
#include "surface/bezier_patch.h"
#include "tests/app/scene_files.h"
#include "tests/support/folders.h"

namespace morphgrid {
namespace {

const std::filesystem::path kScenes = sourceFolder() / "scenes";

TEST(Scene, ControlCharactersInItsTitleAreWrittenOut) {
  const SceneFiles files("title = \"red \\u001B[31m and\\nmore\"\n" + std::string(kBezierScene));
  EXPECT_EQ(files.load().title, "red \\x1b[31m and\\x0amore");
}

void expectCorner(const Scene& scene, const Eigen::Vector3d& corner) {
  const auto* patch = std::get_if<PatchRequest>(&scene.surface);
  ASSERT_TRUE(patch);
  EXPECT_EQ(patch->controlPoints[0][0], corner);
}

void expectDesign(const Scene& scene, int layers, double layerSpacing, int nodesLong,
                  double maxShrinkage) {
  EXPECT_EQ(scene.design.layers, layers);
  EXPECT_EQ(scene.design.layerSpacing, layerSpacing);
  EXPECT_EQ(scene.design.nodesLong, nodesLong);
  EXPECT_EQ(scene.design.maxShrinkage, maxShrinkage);
  EXPECT_EQ(scene.design.curvatureCutoff, 1);
}

TEST(Scenes, Patch) {
  const Scene scene = loadScene(kScenes / "patch.toml");
  EXPECT_EQ(scene.name, "patch");
  EXPECT_EQ(scene.title, "Patch");
  EXPECT_EQ(scene.file, kScenes / "patch.toml");
  expectCorner(scene, {39.356, 0, -148.407});
  expectDesign(scene, 3, 20, 30, 0.4);
  ASSERT_TRUE(scene.published);
  EXPECT_EQ(scene.published->figure, "Fig. 3");
  EXPECT_EQ(scene.published->longestIsolineU, 867.4);
  EXPECT_EQ(scene.published->longestIsolineV, 735.1);
  EXPECT_EQ(scene.published->largestCurvature, 0.0064);
  EXPECT_EQ(scene.published->nodesU, 30);
  EXPECT_EQ(scene.published->nodesV, 26);
  EXPECT_EQ(scene.published->bendShrinkPercent, 25.6);
  EXPECT_EQ(scene.published->l0Percent, 0.57);
  EXPECT_EQ(scene.published->lbPercent, 1.25);
  EXPECT_EQ(scene.published->anglePercent, 2.03);
}

TEST(Scenes, EggChair) {
  const Scene scene = loadScene(kScenes / "egg_chair.toml");
  expectCorner(scene, {-3.543, -5.918, 10.815});
  expectDesign(scene, 3, 0.3, 20, 0.4);
  ASSERT_TRUE(scene.published);
  EXPECT_EQ(scene.published->figure, "Fig. 4");
  EXPECT_EQ(scene.published->longestIsolineU, 12.02);
  EXPECT_EQ(scene.published->nodesU, 17);
  EXPECT_EQ(scene.published->nodesV, 20);
  EXPECT_EQ(scene.published->anglePercent, 7.55);
}

TEST(Scenes, IrisPetal) {
  const Scene scene = loadScene(kScenes / "iris_petal.toml");
  expectCorner(scene, {-1.364, 0, 0.810});
  expectDesign(scene, 4, 0.2, 35, 0.5);
  ASSERT_TRUE(scene.published);
  EXPECT_EQ(scene.published->figure, "Fig. 5");
  EXPECT_EQ(scene.published->longestIsolineV, 14.54);
  EXPECT_EQ(scene.published->nodesU, 20);
  EXPECT_EQ(scene.published->nodesV, 35);
  EXPECT_EQ(scene.published->l0Percent, 0.30);
}

TEST(Scenes, Strip) {
  const Scene scene = loadScene(kScenes / "strip.toml");
  const auto* bent = std::get_if<BendAngleRequest>(&scene.surface);
  ASSERT_TRUE(bent);
  EXPECT_EQ(bent->nodesU, 30);
  EXPECT_EQ(bent->nodesV, 3);
  EXPECT_EQ(scene.design.layers, 4);
  EXPECT_EQ(scene.design.layerSpacing, 0.15);
  EXPECT_EQ(bent->spacing, 1);
  EXPECT_EQ(bent->firstThetaU, 1);
  EXPECT_EQ(bent->lastThetaU, -1);
  EXPECT_EQ(bent->firstThetaV, 0);
  EXPECT_EQ(bent->lastThetaV, 0);
  ASSERT_TRUE(scene.published);
  EXPECT_EQ(scene.published->figure, "Fig. 1(c)");
  EXPECT_FALSE(scene.published->longestIsolineU);
  EXPECT_FALSE(scene.published->nodesU);
}

TEST(Scenes, NodeIsOneAndTheRingBendsByAFullTurn) {
  const auto node = std::get<BendAngleRequest>(loadScene(kScenes / "node.toml").surface);
  EXPECT_EQ(node.nodesU * node.nodesV, 1);
  EXPECT_EQ(node.firstThetaU, 1);
  EXPECT_EQ(node.lastThetaU, 1);
  const auto ring = std::get<BendAngleRequest>(loadScene(kScenes / "ring.toml").surface);
  EXPECT_EQ(ring.firstThetaU, ring.lastThetaU);
  EXPECT_NEAR(ring.nodesU * ring.firstThetaU, 2 * std::numbers::pi, 1e-6);
}

TEST(Scenes, AllLoadWithoutSettingsOfTheirOwnForTheSolver) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kScenes)) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().filename());
    ++count;
    const Scene scene = loadScene(entry.path());
    EXPECT_EQ(scene.method, Method::multigrid);
    EXPECT_EQ(scene.scaling, Scaling::normalised);
    EXPECT_EQ(scene.solve.tolerance, SolveOptions().tolerance);
    EXPECT_EQ(scene.weights.vertical, 40);
  }
  EXPECT_GE(count, 14);
}

TEST(Scenes, HaveTheMeasuresThatThePaperPrints) {
  for (const char* name : {"patch.toml", "egg_chair.toml", "iris_petal.toml"}) {
    SCOPED_TRACE(name);
    const Scene scene = loadScene(kScenes / name);
    const PublishedFigures& paper = *scene.published;
    const SurfaceSurvey survey = loadTarget(scene)->survey();
    EXPECT_NEAR(survey.longestIsolineU, *paper.longestIsolineU, 1e-3 * *paper.longestIsolineU);
    EXPECT_NEAR(survey.longestIsolineV, *paper.longestIsolineV, 1e-3 * *paper.longestIsolineV);
    EXPECT_NEAR(survey.largestCurvature(), *paper.largestCurvature, 0.01 * *paper.largestCurvature);
    const GridSize size = chooseGridSize(survey, scene.design);
    EXPECT_EQ(size.nodesU, paper.nodesU);
    EXPECT_EQ(size.nodesV, paper.nodesV);
    EXPECT_EQ(size.layerSpacing, scene.design.layerSpacing);
    EXPECT_THAT(size.notices, testing::IsEmpty());
  }
}

TEST(Scenes, TheTrueOnesAreFramesLaidOutForTheShape) {
  for (const std::string name : {"patch", "egg_chair", "iris_petal", "face", "torso"}) {
    SCOPED_TRACE(name);
    const Scene papers = loadScene(kScenes / (name + ".toml"));
    const Scene ours = loadScene(kScenes / (name + "_true.toml"));
    EXPECT_EQ(papers.design.net, NetKind::isoline);
    EXPECT_EQ(papers.design.compensateRounds + papers.design.optimiseSteps, 0);
    EXPECT_EQ(papers.material, MaterialRequest());
    EXPECT_EQ(papers.design.layout, Layout::inPlane);
    EXPECT_EQ(ours.material.model, Model::frame);
    EXPECT_EQ(ours.material.leastShrinkage, 0.02);
    EXPECT_EQ(ours.design.layout, Layout::conformal);
    EXPECT_EQ(ours.design.reference, Reference::middle);
    EXPECT_EQ(ours.design.maxStrain, 0.03);
    EXPECT_GT(ours.design.compensateRounds, 0);
    EXPECT_TRUE(ours.design.enforceShrinkage);
    EXPECT_EQ(ours.design.layers, papers.design.layers);
    EXPECT_LE(ours.design.layerSpacing, papers.design.layerSpacing);
    EXPECT_EQ(ours.design.nodesLong, papers.design.nodesLong);
    EXPECT_LE(ours.design.maxShrinkage, papers.design.maxShrinkage == 0.4 ? 0.42 : 0.5);
  }
}

TEST(Scenes, TheCupHasLayersThatAreAThirdOfAStrutApartAtAnySize) {
  for (const auto& [nodes, vertices] : {std::pair{35, 3240}, {100, 25149}, {200, 98892}}) {
    SCOPED_TRACE(nodes);
    const Scene scene =
        loadScene(kScenes / "cup.toml", {"grid.nodes_long=" + std::to_string(nodes),
                                         "grid.layer_spacing=" + std::to_string(18.9 / nodes)});
    const SceneDesign designed = designScene(scene);
    EXPECT_THAT(designed.notices, testing::IsEmpty());
    const GridDesign& design = designed.design;
    EXPECT_EQ((design.nodesU + 1) * (design.nodesV + 1) * design.layers, vertices);
    EXPECT_NEAR(design.layerSpacing / design.spacing, 0.35, 0.005);
  }
}

TEST(LoadScene, LeavesTheDefaultsOfWhatIsNotGiven) {
  const SceneFiles files(kBezierScene);
  const Scene scene = files.load();
  EXPECT_EQ(scene.name, "scene");
  EXPECT_EQ(scene.title, "scene");
  expectDesign(scene, 3, 0.1, 20, 0.4);
  EXPECT_FALSE(scene.design.strutThickness);
  EXPECT_EQ(scene.weights.lateral, 5);
  EXPECT_EQ(scene.weights.vertical, 40);
  EXPECT_EQ(scene.weights.angle, 1);
  EXPECT_EQ(scene.method, Method::multigrid);
  EXPECT_EQ(scene.scaling, Scaling::normalised);
  EXPECT_EQ(scene.solve.tolerance, SolveOptions().tolerance);
  EXPECT_EQ(scene.solve.energyTolerance, SolveOptions().energyTolerance);
  EXPECT_EQ(scene.solve.iterationLimit, 5000);
  EXPECT_TRUE(scene.pictures.enabled);
  EXPECT_EQ(scene.pictures.width, 1280);
  EXPECT_EQ(scene.pictures.height, 960);
  EXPECT_TRUE(scene.files.gltf && scene.files.vtu && scene.files.ply && scene.files.obj);
  EXPECT_FALSE(scene.published);
}

TEST(LoadScene, ReadsEveryKeyOfABezierScene) {
  const SceneFiles files(R"(title = "T\u00e4ßt"
surface = { kind = "bezier", patch = "./p.toml" }
grid = { layers = 64, layer_spacing = 2, nodes_long = 7, max_shrinkage = 0.25, curvature_cutoff = 1, strut_thickness = 0.5 }
weights.lateral = 6
weights.vertical = 4e1
weights.angle = 0
[solver]
method = "reference"
scaling = "shapeop"
tolerance = 1e-12
energy_tolerance = 0
iteration_limit = 0
[output]
pictures = false
width = 64
height = 8192
gltf = false
vtu = false
ply = false
obj = false
)");
  const Scene scene = files.load();
  EXPECT_EQ(scene.title, "T\u00e4\u00dft");
  EXPECT_TRUE(std::holds_alternative<PatchRequest>(scene.surface));
  expectDesign(scene, 64, 2, 7, 0.25);
  EXPECT_EQ(scene.design.strutThickness, 0.5);
  EXPECT_EQ(scene.weights.lateral, 6);
  EXPECT_EQ(scene.weights.vertical, 40);
  EXPECT_EQ(scene.weights.angle, 0);
  EXPECT_EQ(scene.method, Method::reference);
  EXPECT_EQ(scene.scaling, Scaling::shapeop);
  EXPECT_EQ(scene.solve.tolerance, 1e-12);
  EXPECT_EQ(scene.solve.energyTolerance, 0);
  EXPECT_EQ(scene.solve.iterationLimit, 0);
  EXPECT_FALSE(scene.pictures.enabled);
  EXPECT_EQ(scene.pictures.width, 64);
  EXPECT_EQ(scene.pictures.height, 8192);
  EXPECT_FALSE(scene.files.gltf || scene.files.vtu || scene.files.ply || scene.files.obj);
}

TEST(LoadScene, ReadsEveryKeyOfABendAnglesScene) {
  EXPECT_THAT(SceneFiles(std::string(kBendAnglesScene) + "[elsewhere]\n").problems(),
              testing::StartsWith("scene.toml:7:2: unknown key elsewhere; known here: extends, "
                                  "title, surface, material, print, grid, "));
  const Scene scene = SceneFiles(R"([surface]
kind = "bend_angles"
theta_u = [0.5, 1]
theta_v = [-3.141592653589793, 3.141592653589793]
spacing = 3
[grid]
layers = 2
layer_spacing = 0.1
nodes_u = 4
nodes_v = 5
)")
                          .load();
  const auto* bent = std::get_if<BendAngleRequest>(&scene.surface);
  ASSERT_TRUE(bent);
  EXPECT_EQ(bent->firstThetaU, 0.5);
  EXPECT_EQ(bent->lastThetaU, 1);
  EXPECT_EQ(bent->firstThetaV, -3.141592653589793);
  EXPECT_EQ(bent->lastThetaV, 3.141592653589793);
  EXPECT_EQ(bent->spacing, 3);
  EXPECT_EQ(scene.design.layers, 2);
  EXPECT_EQ(scene.design.layerSpacing, 0.1);
  EXPECT_EQ(bent->nodesU, 4);
  EXPECT_EQ(bent->nodesV, 5);
}

TEST(LoadScene, TakesWindowsLineEndsAndAByteOrderMark) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : std::string(kBezierScene)) text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(SceneFiles(text).load().design.layerSpacing, 0.1);
  EXPECT_EQ(SceneFiles(text + "layers = 0\r\n").problems(),
            "scene.toml:6:10: grid.layers must be an integer >= 1 and <= 64, got 0");
}

TEST(KnownSceneKeys, AreUniqueAndOfAllSections) {
  const std::vector<std::string> keys = knownSceneKeys();
  EXPECT_EQ(std::set(keys.begin(), keys.end()).size(), keys.size());
  EXPECT_THAT(keys, testing::IsSupersetOf({"title", "surface.kind", "grid.nodes_u", "weights.angle",
                                           "solver.method", "output.obj", "paper.angle_percent"}));
}

}  // namespace
}  // namespace morphgrid
