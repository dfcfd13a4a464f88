// Long runs: killed, interrupted, on a device that fails.
#include <gmock/gmock.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/checkpoint.h"
#include "tests/app/subprocess.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

class LongRun : public testing::Test {
 protected:
  /// Without pictures, into the folder `name`.
  std::vector<std::string> run(const std::string& name,
                               const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"run",   sourceFolder() / "scenes/egg_chair.toml",
                                       "--out", folder_ / name,
                                       "--set", "grid.nodes_long=16",
                                       "--set", "output.pictures=false"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  nlohmann::json report(const std::string& name) const {
    std::ifstream stream(folder_ / name / "report.json");
    return nlohmann::json::parse(stream);
  }
  std::string checkpoint() const { return folder_ / "run.checkpoint"; }
  bool isInFullStage() const {
    return std::filesystem::exists(checkpoint()) && readCheckpoint(checkpoint()).inPlane;
  }

  TemporaryFolder folder_;
};

struct Killed {
  const char* method;
  bool inFullStage;
};

class KilledRun : public LongRun, public testing::WithParamInterface<Killed> {};

TEST_P(KilledRun, GoesOnToTheSameAnswer) {
  const std::string method = std::string("solver.method=") + GetParam().method;
  ASSERT_EQ(runMorphgrid(run("whole", {"--quiet", "--set", method})).exitCode, 0);
  // Tolerances may change on the way; these keep it busy until it is killed.
  const bool full = GetParam().inFullStage;
  const ProcessResult killed = runMorphgridUntil(
      [&](const std::string&) {
        return full ? isInFullStage() : std::filesystem::exists(checkpoint());
      },
      run("killed",
          {"--quiet", "--checkpoint", checkpoint(), "--checkpoint-minutes", "1e-9", "--set", method,
           "--set", full ? "solver.tolerance=1e-9" : "solver.tolerance=1e-15", "--set",
           full ? "solver.energy_tolerance=1e-9" : "solver.energy_tolerance=0"}),
      SIGKILL);
  ASSERT_EQ(killed.exitCode, 128 + 9) << killed.output;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "killed/report.json"));

  const ProcessResult resumed = runMorphgrid(
      run("resumed", {"--quiet", "--set", method, "--resume", checkpoint(), "--validate"}));
  EXPECT_EQ(resumed.exitCode, 0) << resumed.output;
  const auto whole = report("whole");
  const auto other = report("resumed");
  EXPECT_NEAR(other["full"]["energy"].get<double>() / whole["full"]["energy"].get<double>(), 1,
              1e-7);
  EXPECT_NEAR(other["distance_to_target"]["rms_percent"].get<double>(),
              whole["distance_to_target"]["rms_percent"].get<double>(), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Methods, KilledRun,
                         testing::Values(Killed{"multigrid", false}, Killed{"multigrid", true},
                                         Killed{"jacobi", true}, Killed{"reference", true}),
                         [](const auto& test) {
                           return std::string(test.param.method) +
                                  (test.param.inFullStage ? "Full" : "InPlane");
                         });

TEST_F(LongRun, InterruptedLeavesACheckpoint) {
  const ProcessResult interrupted = runMorphgridUntil(
      [](const std::string& output) { return output.find("iterations") != std::string::npos; },
      run("interrupted", {"--checkpoint", checkpoint(), "--set", "solver.tolerance=1e-15", "--set",
                          "solver.energy_tolerance=0", "--set", "grid.nodes_long=60"}),
      SIGINT);
  ASSERT_EQ(interrupted.exitCode, 130) << interrupted.output;
  EXPECT_NO_THROW(readCheckpoint(checkpoint()));
}

TEST_F(LongRun, BadCheckpointsAreToldBeforeTheSolve) {
  const auto other = folder_.write("other.checkpoint", "something else");
  for (const char* option : {"--checkpoint", "--resume"}) {
    const ProcessResult bad = runMorphgrid(run("bad", {option, other}));
    EXPECT_EQ(bad.exitCode, 2) << option;
    EXPECT_THAT(bad.output, HasSubstr("other.checkpoint: is")) << option;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "bad")) << option;
  }
  EXPECT_EQ(runMorphgrid(run("bad", {"--checkpoint-minutes", "1"})).exitCode, 2);
  EXPECT_EQ(runMorphgrid(run("bad", {"--checkpoint", checkpoint(), "--checkpoint-minutes", "0"}))
                .exitCode,
            2);
}

std::vector<std::string> failingDevice(const std::string& variable, int value) {
  return {"VK_INSTANCE_LAYERS=VK_LAYER_MORPHGRID_failing_device",
          "VK_LAYER_PATH=" + (binaryFolder() / "layers").string(),
          "MORPHGRID_FAILING_DEVICE_" + variable + "=" + std::to_string(value)};
}

/// Inverse design in the middle of its steps.
class InverseDesignRun : public LongRun {
 protected:
  std::vector<std::string> design(const std::string& name,
                                  const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"run",   sourceFolder() / "scenes/egg_chair_true.toml",
                                       "--out", folder_ / name,
                                       "--set", "material.model=paper",
                                       "--set", "design.net=orthogonal",
                                       "--set", "design.compensate=2",
                                       "--set", "grid.nodes_long=30",
                                       "--set", "output.pictures=false",
                                       "--set", "design.optimise=25"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  std::vector<std::string> keepingCheckpoints(const std::string& name,
                                              std::vector<std::string> more = {}) const {
    more.insert(more.end(),
                {"--quiet", "--checkpoint", checkpoint(), "--checkpoint-minutes", "1e-9"});
    return design(name, more);
  }
  bool hasSteps(std::size_t count) const {
    if (!std::filesystem::exists(checkpoint())) {
      return false;
    }
    const Checkpoint read = readCheckpoint(checkpoint());
    return read.inverse && read.inverse->steps.size() >= count;
  }
  static double rmsOf(const nlohmann::json& step) { return step["rms_percent"].get<double>(); }

  /// The end of a run that goes on from the checkpoint is that of the whole one.
  void expectSameEnd(const nlohmann::json& resumed, const nlohmann::json& whole,
                     std::size_t stepsBefore) const {
    const auto& steps = resumed["inverse_design"]["steps"];
    const auto& wholeSteps = whole["inverse_design"]["steps"];
    ASSERT_EQ(steps.size(), wholeSteps.size());
    for (std::size_t n = 0; n < steps.size(); ++n) {
      EXPECT_EQ(steps[n]["number"], wholeSteps[n]["number"]);
      // The same until then; from there on to the tolerance of equilibria.
      EXPECT_NEAR(rmsOf(steps[n]), rmsOf(wholeSteps[n]),
                  (n < stepsBefore ? 1e-9 : 0.05) * rmsOf(wholeSteps[n]))
          << n;
      if (n > 0) {
        EXPECT_GE(steps[n]["seconds"].get<double>(), steps[n - 1]["seconds"].get<double>());
      }
    }
    EXPECT_EQ(resumed["inverse_design"]["ending"], whole["inverse_design"]["ending"]);
    EXPECT_NEAR(rmsOf(resumed["distance_to_target"]), rmsOf(whole["distance_to_target"]),
                0.02 * rmsOf(whole["distance_to_target"]));
  }
};

TEST_F(InverseDesignRun, GoesOnAfterAKill) {
  ASSERT_EQ(runMorphgrid(design("whole", {"--quiet"})).exitCode, 0);
  const ProcessResult killed = runMorphgridUntil([&](const std::string&) { return hasSteps(4); },
                                                 keepingCheckpoints("killed"), SIGKILL);
  ASSERT_EQ(killed.exitCode, 128 + 9) << killed.output;
  const std::size_t before = readCheckpoint(checkpoint()).inverse->steps.size();
  ASSERT_LT(before, report("whole")["inverse_design"]["steps"].size());
  const ProcessResult resumed =
      runMorphgrid(design("resumed", {"--quiet", "--resume", checkpoint(), "--validate"}));
  ASSERT_EQ(resumed.exitCode, 0) << resumed.output;
  expectSameEnd(report("resumed"), report("whole"), before);
}

// With the rotations of its joints, and the aim that it had come to.
TEST_F(InverseDesignRun, OfAFrameGoesOnAfterAKill) {
  const std::vector<std::string> frame{"--set", "material.model=frame",
                                       "--set", "design.net=isoline",
                                       "--set", "design.optimise=12"};
  const ProcessResult killed = runMorphgridUntil([&](const std::string&) { return hasSteps(3); },
                                                 keepingCheckpoints("killed", frame), SIGKILL);
  ASSERT_EQ(killed.exitCode, 128 + 9) << killed.output;
  const InverseCheckpoint before = *readCheckpoint(checkpoint()).inverse;
  EXPECT_GT(before.present.equilibrium.rotations.cols(), 0);
  EXPECT_GT(before.aim.cols(), 0);
  std::vector<std::string> resuming = frame;
  resuming.insert(resuming.end(), {"--quiet", "--resume", checkpoint(), "--validate"});
  const ProcessResult resumed = runMorphgrid(design("resumed", resuming));
  ASSERT_EQ(resumed.exitCode, 0) << resumed.output;
  const auto after = report("resumed");
  const auto& steps = after["inverse_design"]["steps"];
  ASSERT_GT(steps.size(), before.steps.size());
  for (std::size_t n = 0; n < before.steps.size(); ++n) {
    EXPECT_NEAR(rmsOf(steps[n]), before.steps[n].rmsPercent, 1e-9);
  }
  EXPECT_LT(rmsOf(steps.back()), before.steps.back().rmsPercent);
  EXPECT_LT(rmsOf(steps.back()), 0.02);
}

TEST_F(InverseDesignRun, InterruptedKeepsWhatIsThereAndGoesOn) {
  ASSERT_EQ(runMorphgrid(design("whole", {"--quiet"})).exitCode, 0);
  const ProcessResult interrupted = runMorphgridUntil(
      [&](const std::string&) { return hasSteps(4); }, keepingCheckpoints("interrupted"), SIGINT);
  ASSERT_EQ(interrupted.exitCode, 130) << interrupted.output;
  const auto left = report("interrupted");
  EXPECT_EQ(left["inverse_design"]["ending"], "interrupted");
  const auto& steps = left["inverse_design"]["steps"];
  ASSERT_GE(steps.size(), 4);
  EXPECT_NEAR(rmsOf(left["distance_to_target"]), rmsOf(steps.back()), 1e-6);
  EXPECT_EQ(readCheckpoint(checkpoint()).inverse->steps.size(), steps.size());
  ASSERT_EQ(runMorphgrid(design("resumed", {"--quiet", "--resume", checkpoint()})).exitCode, 0);
  expectSameEnd(report("resumed"), report("whole"), steps.size());
}

TEST_F(InverseDesignRun, ALostDeviceLeavesTheBestDesignSoFar) {
  const ProcessResult lost =
      runMorphgrid(keepingCheckpoints("lost"), failingDevice("SUBMITS", 700));
  ASSERT_EQ(lost.exitCode, 4) << lost.output;
  const auto left = report("lost");
  EXPECT_EQ(left["inverse_design"]["ending"], "device failure");
  const auto& steps = left["inverse_design"]["steps"];
  ASSERT_GT(steps.size(), 3);
  EXPECT_LT(rmsOf(left["distance_to_target"]), 0.5 * rmsOf(steps.front()));
  // It may have been settled, or improved, since that step was reported.
  EXPECT_LT(rmsOf(left["distance_to_target"]), 1.001 * rmsOf(steps.back()));
  EXPECT_GT(rmsOf(left["distance_to_target"]), 0.9 * rmsOf(steps.back()));
  EXPECT_EQ(runMorphgrid(design("resumed", {"--quiet", "--resume", checkpoint()})).exitCode, 0);
}

class LostDevice : public LongRun, public testing::WithParamInterface<int> {};

TEST_P(LostDevice, LeavesWhatWasDone) {
  const auto environment = failingDevice("SUBMITS", GetParam());
  const ProcessResult lost = runMorphgrid(run("lost", {"--checkpoint", checkpoint()}), environment);
  EXPECT_EQ(lost.exitCode, 4) << lost.output;
  EXPECT_THAT(lost.output, HasSubstr("ErrorDeviceLost"));
  EXPECT_THAT(lost.output, HasSubstr("what was done before is in"));
  for (const char* file : {"report.json", "convergence.csv", "warped.glb", "surface.obj"}) {
    EXPECT_TRUE(std::filesystem::exists(folder_ / "lost" / file)) << file;
  }
  const auto json = report("lost");
  EXPECT_EQ(json["full"]["reason"], "device failure");
  EXPECT_EQ(json["full"]["converged"], false);
  EXPECT_THAT(json["device_failure"].get<std::string>(), HasSubstr("ErrorDeviceLost"));
  if (std::filesystem::exists(checkpoint())) {
    EXPECT_THAT(lost.output, HasSubstr("--resume"));
    EXPECT_EQ(runMorphgrid(run("resumed", {"--quiet", "--resume", checkpoint()})).exitCode, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Submissions, LostDevice, testing::Values(0, 3, 20, 50, 130),
                         testing::PrintToStringParamName());

TEST_F(LongRun, TheReferenceMethodLosesOnlyPictures) {
  auto arguments = run("lost", {"--set", "output.pictures=true", "--set", "solver.method=reference",
                                "--set", "output.width=320", "--set", "output.height=240"});
  const ProcessResult lost = runMorphgrid(arguments, failingDevice("SUBMITS", 8));
  EXPECT_EQ(lost.exitCode, 4) << lost.output;
  EXPECT_EQ(report("lost")["full"]["converged"], true);
}

TEST_F(LongRun, MemoryThatCannotBeHadIsADeviceFailure) {
  const ProcessResult run = runMorphgrid(this->run("small"), failingDevice("BYTES", 1000));
  EXPECT_EQ(run.exitCode, 4) << run.output;
  EXPECT_THAT(run.output, testing::ContainsRegex("[0-9]+ bytes of device memory cannot be had"));
}

}  // namespace
}  // namespace morphgrid
