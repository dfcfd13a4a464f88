#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/read_file.h"
#include "tests/app/subprocess.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

/// What a scene designed for the frame must reach, morphed from flat.
struct Goal {
  const char* scene;
  double rmsPercent;
  double maxPercent;
  double meanAngleDegrees;  ///< Of the sheet.
  double leastStiffness;    ///< Over that of the flat sheet.
};

class TrueScenes : public testing::TestWithParam<Goal> {};

TEST_P(TrueScenes, ReachTheirTargetAsFrames) {
  const Goal& goal = GetParam();
  const TemporaryFolder folder;
  std::vector<std::string> arguments{"run", sourceFolder() / "scenes" / goal.scene, "--out",
                                     folder / "out", "--quiet"};
  for (const char* format : {"pictures", "gltf", "vtu", "ply", "obj", "state"}) {
    arguments.insert(arguments.end(), {"--set", std::string("output.") + format + "=false"});
  }
  const ProcessResult run = runMorphgrid(arguments);
  ASSERT_EQ(run.exitCode, 0) << run.output;
  const auto report = nlohmann::json::parse(readFile(folder / "out/report.json"));
  EXPECT_EQ(report["model"], "frame");
  EXPECT_LE(report["distance_to_target"]["rms_percent"].get<double>(), goal.rmsPercent);
  EXPECT_LE(report["distance_to_target"]["max_percent"].get<double>(), goal.maxPercent);
  EXPECT_LE(report["sheet"]["mean_angle_error_degrees"].get<double>(), goal.meanAngleDegrees);
  EXPECT_EQ(report["shrink"]["struts_over_limit"], 0);
  EXPECT_EQ(report["shrink"]["struts_under_least"], 0);
  EXPECT_EQ(report["strain"]["struts_over_limit"], 0);
  const auto& fromFlat = report["inverse_design"]["from_flat"];
  EXPECT_EQ(fromFlat["same_equilibrium"], true);
  EXPECT_GE(fromFlat["least_eigenvalue_ratio"].get<double>(), goal.leastStiffness);
}

// The paper's sheet in the frame: one corner curls, and its mirror twin is as likely.
TEST(PapersSheet, LosesItsSymmetryAsAFrame) {
  const TemporaryFolder folder;
  const auto reportWith = [&](const std::string& model) {
    const ProcessResult run =
        runMorphgrid({"run", sourceFolder() / "scenes/egg_chair.toml", "--out", folder / model,
                      "--quiet", "--set", "output.pictures=false", "--set",
                      "material.model=" + model, "--set", "design.layout=in_plane"});
    EXPECT_EQ(run.exitCode, 0) << run.output;
    return nlohmann::json::parse(readFile(folder / (model + "/report.json")));
  };
  const auto springs = reportWith("paper");
  EXPECT_EQ(springs["symmetry"]["kind"], "mirror across u");
  EXPECT_LT(springs["symmetry"]["result_percent"].get<double>(), 0.01);
  const auto frame = reportWith("frame");
  EXPECT_GT(frame["symmetry"]["result_percent"].get<double>(), 1);
  EXPECT_THAT(frame["notices"],
              testing::Contains(testing::ResultOf(
                  [](const nlohmann::json& notice) { return notice.get<std::string>(); },
                  testing::HasSubstr("has buckled to one side"))));
}

INSTANTIATE_TEST_SUITE_P(Scenes, TrueScenes,
                         testing::Values(Goal{"egg_chair_true.toml", 0.05, 0.2, 1.5, 2},
                                         Goal{"iris_petal_true.toml", 0.05, 0.2, 0.2, 0.7},
                                         Goal{"torso_true.toml", 0.05, 0.2, 0.3, 0.4},
                                         Goal{"patch_true.toml", 0.15, 0.6, 0.6, 1.5}));

}  // namespace
}  // namespace morphgrid
