// Commands that go on from the state of a finished run.
#include <gmock/gmock.h>

#include <filesystem>

#include "core/read_file.h"
#include "state/run_state.h"
#include "tests/app/subprocess.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;
using Arguments = std::vector<std::string>;

class RunStateCommands : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_ / name; }

  /// Runs a command on a small grid, with small pictures. Returns the exit code.
  int run(const std::string& command, const std::string& scene, const Arguments& more) const {
    Arguments arguments{command, sourceFolder() / "scenes" / (scene + ".toml"), "--quiet"};
    for (const char* value : {"output.width=160", "output.height=120"}) {
      arguments.insert(arguments.end(), {"--set", value});
    }
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runMorphgrid(arguments).exitCode;
  }

  TemporaryFolder folder_;
};

TEST_F(RunStateCommands, FiguresAreThoseOfTheScene) {
  const std::vector<std::pair<std::string, Arguments>> cases{
      {"egg_chair", {"--set", "grid.nodes_long=6"}},
      {"egg_chair_true", {"--set", "grid.nodes_long=6", "--set", "design.optimise=1"}},
      {"face", {"--set", "grid.nodes_long=8"}},
      {"node", {}},
      {"patch", {"--set", "grid.layers=1", "--set", "grid.nodes_long=6"}},
  };
  for (const auto& [scene, more] : cases) {
    Arguments arguments = more;
    arguments.insert(arguments.end(), {"--out", path(scene), "--set", "output.pictures=false"});
    ASSERT_EQ(run("run", scene, arguments), 0) << scene;
    arguments = more;
    arguments.insert(arguments.end(), {"--out", path(scene + ".png")});
    ASSERT_EQ(run("figures", scene, arguments), 0) << scene;
    const ProcessResult again = runMorphgrid({"figures", path(scene), "--validate"});
    ASSERT_EQ(again.exitCode, 0) << again.output;
    EXPECT_EQ(readFile(path(scene) + "/figures.png"), readFile(path(scene + ".png"))) << scene;
  }
}

TEST_F(RunStateCommands, TheMorphIsSolvedFromTheState) {
  ASSERT_EQ(run("run", "egg_chair", {"--out", path("egg"), "--set", "grid.nodes_long=6"}), 0);
  const ProcessResult film =
      runMorphgrid({"figures", path("egg/state.safetensors"), "--out", path("sheet.png"), "--gltf",
                    path("morph.glb"), "--frame-count", "3"});
  EXPECT_EQ(film.exitCode, 0) << film.output;
  EXPECT_TRUE(std::filesystem::exists(path("morph.glb")));
}

TEST_F(RunStateCommands, WhatDoesNotGoTogetherIsTold) {
  ASSERT_EQ(run("run", "node", {"--out", path("node")}), 0);
  const std::string scene = sourceFolder() / "scenes" / "node.toml";
  const ProcessResult twice = runMorphgrid({"run", path("node")});
  EXPECT_EQ(twice.exitCode, 2);
  EXPECT_THAT(twice.output, HasSubstr("is a finished run"));
  EXPECT_THAT(twice.output, HasSubstr("takes its scene: " + scene));
  const ProcessResult changed = runMorphgrid({"figures", path("node"), "--set", "grid.layers=4"});
  EXPECT_EQ(changed.exitCode, 2);
  EXPECT_THAT(changed.output, HasSubstr("which --set cannot change"));
  const ProcessResult resumed =
      runMorphgrid({"run", scene, "--resume", path("node/state.safetensors")});
  EXPECT_EQ(resumed.exitCode, 2);
  EXPECT_THAT(resumed.output, HasSubstr("is no checkpoint"));
  folder_.write("empty/report.json", "");
  EXPECT_THAT(runMorphgrid({"figures", path("empty")}).output,
              HasSubstr("there is no state.safetensors in this folder"));
  folder_.write("damaged/state.safetensors", "rubbish");
  for (const char* command : {"figures", "view"}) {
    EXPECT_THAT(runMorphgrid({command, path("damaged")}).output,
                HasSubstr("is no state of morphgrid; run the scene again"));
  }
  EXPECT_THAT(runMorphgrid({"view", path("node"), "--set", "grid.layers=0"}).output,
              HasSubstr("grid.layers must be an integer >= 1"));
}

TEST_F(RunStateCommands, ARunThatDidNotConvergeSaysSo) {
  ASSERT_EQ(run("run", "egg_chair",
                {"--out", path("egg"), "--set", "grid.nodes_long=6", "--set",
                 "solver.iteration_limit=1"}),
            3);
  const ProcessResult figures = runMorphgrid({"figures", path("egg")});
  EXPECT_EQ(figures.exitCode, 3) << figures.output;
  EXPECT_THAT(figures.output, HasSubstr("the run did not converge (iteration limit)"));
}

TEST_F(RunStateCommands, NoStateIsLeftWhereNoneIsWanted) {
  ASSERT_EQ(run("run", "node", {"--out", path("node"), "--set", "output.state=false"}), 0);
  EXPECT_FALSE(std::filesystem::exists(path("node/state.safetensors")));
}

}  // namespace
}  // namespace morphgrid
