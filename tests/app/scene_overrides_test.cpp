#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/scene_files.h"

namespace morphgrid {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Overrides, ReplaceAndAddValues) {
  const SceneFiles files(std::string(kBezierScene) + "layers = 5\n");
  const Scene scene = files.load({"grid.layers=4", "grid.layer_spacing = 2", "weights.angle=0.5",
                                  "output.gltf=false", "title=\"A = B\""});
  EXPECT_EQ(scene.design.layers, 4);
  EXPECT_EQ(scene.design.layerSpacing, 2);
  EXPECT_EQ(scene.design.nodesLong, 20);
  EXPECT_EQ(scene.weights.angle, 0.5);
  EXPECT_FALSE(scene.files.gltf);
  EXPECT_EQ(scene.title, "A = B");
}

TEST(Overrides, NeedNoQuotesForWords) {
  const SceneFiles files(kBezierScene);
  const Scene scene = files.load({"solver.method=reference", "surface.patch=./p.toml",
                                  "title= Two words ", "paper.figure=Fig. 1(c)"});
  EXPECT_EQ(scene.method, Method::reference);
  EXPECT_EQ(scene.title, "Two words");
  EXPECT_EQ(scene.published->figure, "Fig. 1(c)");
}

TEST(Overrides, TheLastOneCounts) {
  EXPECT_EQ(SceneFiles(kBezierScene).load({"grid.layers=4", "grid.layers=6"}).design.layers, 6);
  EXPECT_EQ(SceneFiles(kBezierScene).load({"grid.layers=x", "grid.layers=6"}).design.layers, 6);
}

TEST(Overrides, MendABadFile) {
  const SceneFiles files("[surface]\nkind = \"bend_angles\"\n[grid]\nlayers = 0\nnodes_u = 2\n");
  EXPECT_NE(files.problems(), "");
  const Scene scene =
      files.load({"grid.layers=2", "grid={nodes_v=3, layer_spacing=1}", "surface.theta_u=[1,-1]"});
  const auto& bent = std::get<BendAngleRequest>(scene.surface);
  EXPECT_EQ(scene.design.layers, 2);
  EXPECT_EQ(bent.nodesU, 2);
  EXPECT_EQ(bent.nodesV, 3);
  EXPECT_EQ(bent.lastThetaU, -1);
}

TEST(Overrides, BadOnesAreReportedAsGiven) {
  struct OverrideCase {
    const char* assignment;
    const char* message;
  };
  const OverrideCase cases[] = {
      {"grid.layers=x",
       "--set grid.layers=x: grid.layers must be an integer >= 1 and <= 64, got \"x\""},
      {"grid.layers=0",
       "--set grid.layers=0: grid.layers must be an integer >= 1 and <= 64, got 0"},
      {"grid.layers=4 5",
       "--set grid.layers=4 5: grid.layers must be an integer >= 1 and <= 64, got \"4 5\""},
      {"grid.layers.x=1",
       "--set grid.layers.x=1: grid.layers must be an integer >= 1 and <= 64, got a table"},
      {"grid=1", "--set grid=1: grid must be a table, got 1"},
      {"grid.lairs=1", "--set grid.lairs=1: unknown key grid.lairs; did you mean grid.layers?"},
      {"girds.layers=1", "--set girds.layers=1: unknown key girds; did you mean grid?"},
      {"layers=1", "--set layers=1: unknown key layers; did you mean grid.layers?"},
      {"grid.nodes_u=1",
       "--set grid.nodes_u=1: grid.nodes_u belongs to surfaces of kind \"bend_angles\", this one "
       "is \"bezier\""},
      {"surface.patch=none.toml",
       "--set surface.patch=none.toml: surface.patch must name a readable file, got none.toml: No "
       "such file or directory"},
      {"grid.nodes_long=2000000000",
       "--set grid.nodes_long=2000000000: grid.nodes_long asks for too large a grid: at most "
       "715827882 vertices are possible, got 1.2e+10"},
      {"grid.layers", "--set grid.layers: must be key=value on one line, e.g. grid.layers=4"},
      {"", "--set : must be key=value on one line, e.g. grid.layers=4"},
      {"grid.layers=", "--set grid.layers=: must be key=value on one line, e.g. grid.layers=4"},
      {"a=1\nb=2", "--set a=1: must be key=value on one line, e.g. grid.layers=4"},
  };
  const SceneFiles files(kBezierScene);
  for (const OverrideCase& bad : cases) {
    SCOPED_TRACE(bad.assignment);
    EXPECT_EQ(files.problems({bad.assignment}), bad.message);
  }
}

TEST(Overrides, MalformedOnesAreReportedOnOneLine) {
  const SceneFiles files(kBezierScene);
  for (const std::string assignment :
       {"=4", "grid.layers=[1", "title=\"x", "gr id=4", "grid..layers=4", "title=it's", "a={b=1"}) {
    SCOPED_TRACE(assignment);
    EXPECT_THAT(
        files.problems({assignment}),
        AllOf(StartsWith("--set " + assignment + ": not valid TOML: "), Not(HasSubstr("\n"))));
  }
}

TEST(Overrides, AllProblemsAtOnce) {
  const SceneFiles files("[surface]\nkind = \"bezier\"\npatch = \"p.toml\"\n");
  EXPECT_EQ(
      files.problems({"grid.layers=0", "weights.angle=-1", "grid.lairs=1"}),
      "scene.toml:1:1: grid.layer_spacing is missing: it must be a number >= 1e-30 and <= 1e+15\n"
      "--set grid.layers=0: grid.layers must be an integer >= 1 and <= 64, got 0\n"
      "--set weights.angle=-1: weights.angle must be a number >= 0 and <= 1e+09, got -1\n"
      "--set grid.lairs=1: unknown key grid.lairs; did you mean grid.layers?");
  EXPECT_THAT(SceneFiles("[").problems({"a", "b=[1"}),
              AllOf(StartsWith("scene.toml:1:2: not valid TOML: "), HasSubstr("\n--set a: must be"),
                    HasSubstr("\n--set b=[1: not valid TOML: ")));
}

}  // namespace
}  // namespace morphgrid
