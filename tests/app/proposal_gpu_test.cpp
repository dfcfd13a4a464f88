#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/read_file.h"
#include "tests/app/subprocess.h"
#include "tests/propose/bowls.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

TEST(MeshOnTheCommandLine, RunsWithoutAScene) {
  const TemporaryFolder folder;
  const auto mesh = folder.write("bowl.obj", toObj(bowl(12)));
  const auto out = folder / "result";
  const ProcessResult run =
      runMorphgrid({"run", mesh.string(), "--out", out.string(), "--set", "grid.nodes_long=8",
                    "--set", "output.width=320", "--set", "output.height=240"});
  EXPECT_EQ(run.exitCode, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("seen along -z"));
  for (const char* file :
       {"bowl.toml", "bowl_mesh.toml", "preview.png", "warped.png", "report.json"}) {
    EXPECT_TRUE(std::filesystem::exists(out / file)) << file;
  }
  const auto report = nlohmann::json::parse(readFile(out / "report.json"));
  EXPECT_LT(report["distance_to_target"]["rms_percent"], 0.3);
}

TEST(MeshOnTheCommandLine, KeepsASceneThatWasChanged) {
  const TemporaryFolder folder;
  const auto mesh = folder.write("bowl.obj", toObj(bowl(12)));
  const std::vector<std::string> command = {
      "new", mesh.string(), "--out", (folder / "b").string(), "--size", "50"};
  EXPECT_EQ(runMorphgrid(command).exitCode, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "b/bowl_before.toml"));
  folder.write("b/bowl.toml", "# mine\n");
  const ProcessResult again = runMorphgrid(command);
  EXPECT_EQ(again.exitCode, 0);
  EXPECT_THAT(again.output, HasSubstr("bowl_before.toml"));
  EXPECT_EQ(readFile(folder / "b/bowl_before.toml"), "# mine\n");
  folder.write("b/bowl.toml", "# mine, too\n");
  EXPECT_EQ(runMorphgrid(command).exitCode, 0);
  EXPECT_EQ(readFile(folder / "b/bowl_before.toml"), "# mine\n");
  EXPECT_EQ(readFile(folder / "b/bowl_before_2.toml"), "# mine, too\n");
  EXPECT_THAT(readFile(folder / "b/bowl.toml"), HasSubstr("u_length = 5"));
}

TEST(MeshOnTheCommandLine, ThatCannotBeReadIsToldWithItsFile) {
  const TemporaryFolder folder;
  const auto mesh = folder.write("bad.obj", "v 0 0 0\n");
  for (const char* command : {"new", "run", "check", "figures"}) {
    const ProcessResult result = runMorphgrid({command, mesh.string()});
    EXPECT_EQ(result.exitCode, 2) << command;
    EXPECT_THAT(result.output, HasSubstr("bad.obj")) << command;
  }
}

}  // namespace
}  // namespace morphgrid
