// The program as a user runs it, under the validation layers.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/mount.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/read_file.h"
#include "tests/app/subprocess.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

class Run : public testing::Test {
 protected:
  static std::string sceneFile(const std::string& name) {
    return sourceFolder() / "scenes" / (name + ".toml");
  }
  std::string out() const { return (folder_.path() / "result").string(); }
  nlohmann::json report() const {
    std::ifstream stream(out() + "/report.json");
    return nlohmann::json::parse(stream);
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(out() + "/" + name); }

  TemporaryFolder folder_;
};

TEST_F(Run, LeavesReportPicturesAndFiles) {
  const ProcessResult run =
      runMorphgrid({"run", sceneFile("egg_chair"), "--out", out(), "--validate", "--set",
                    "grid.nodes_long=8", "--set", "grid.strut_thickness=0.31", "--set",
                    "output.width=320", "--set", "output.height=240"});
  EXPECT_EQ(run.exitCode, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("paper Fig. 4"));
  EXPECT_THAT(run.output, HasSubstr("closer to another than grid.strut_thickness = 0.31"));
  for (const char* file :
       {"report.json", "convergence.csv", "initial.png", "in_plane.png", "stacked.png",
        "shrink.png", "warped.png", "surface.png", "target.png", "distance.png", "warped.glb",
        "warped.vtu", "printed.vtu", "surface.ply", "surface.obj"}) {
    EXPECT_TRUE(exists(file)) << file;
  }
  const auto json = report();
  EXPECT_EQ(json["scene"], "egg_chair");
  EXPECT_EQ(json["full"]["converged"], true);
  EXPECT_TRUE(json["full"]["reason"] == "residual" || json["full"]["reason"] == "energy");
  EXPECT_LE(json["full"]["residual"].get<double>(), 1e-8);
  EXPECT_GT(json["distance_to_target"]["rms_percent"].get<double>(), 0);
  EXPECT_EQ(json["feasibility"]["inverted_cells"], 0);
  EXPECT_EQ(json["feasibility"]["self_intersecting_cells"], 0);
  EXPECT_GT(json["feasibility"]["close_struts"]["count"], 0) << "the layers' spacing is 0.3";
  EXPECT_LE(json["distance_to_target"]["closest_point_rms_percent"].get<double>(),
            json["distance_to_target"]["rms_percent"].get<double>());
}

/// As printed, the sheet is the same with and without; which struts are to shrink is not.
TEST_F(Run, StackedLayersAreDrawnWithTheLengthsThatInverseDesignLeaves) {
  const auto runWith = [&](const std::string& folder, const char* rounds) {
    const ProcessResult run =
        runMorphgrid({"run", sceneFile("egg_chair"), "--out", folder, "--quiet", "--set",
                      "grid.nodes_long=6", "--set", std::string("design.compensate=") + rounds,
                      "--set", "output.width=200", "--set", "output.height=150"});
    EXPECT_EQ(run.exitCode, 0) << run.output;
    return readFile(folder + "/stacked.png");
  };
  const std::string designed = runWith(folder_ / "designed", "0");
  const std::string corrected = runWith(out(), "2");
  ASSERT_GT(report()["inverse_design"]["steps"].size(), 0);
  EXPECT_NE(corrected, designed);
}

TEST_F(Run, WeldedBarsComeToRestAlikeByBothMethods) {
  std::vector<double> energies;
  for (const char* method : {"multigrid", "reference"}) {
    const ProcessResult run = runMorphgrid(
        {"run", sceneFile("iris_petal"), "--out", out(), "--validate", "--set", "grid.nodes_long=8",
         "--set", "material.model=frame", "--set", std::string("solver.method=") + method, "--set",
         "output.width=320", "--set", "output.height=240"});
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, ContainsRegex("model +frame"));
    EXPECT_EQ(report()["model"], "frame");
    EXPECT_EQ(report()["full"]["converged"], true) << method;
    energies.push_back(report()["full"]["energy"]);
    EXPECT_TRUE(exists("warped.png"));
  }
  EXPECT_NEAR(energies[0], energies[1], 1e-6 * energies[0]);
  const ProcessResult figures = runMorphgrid({"figures", out(), "--validate"});
  EXPECT_EQ(figures.exitCode, 0) << figures.output;
}

TEST_F(Run, ThinGridsSagAlikeByBothMethodsAndThickOnesHold) {
  const auto weightOf = [&](const char* layerSpacing, const char* method) {
    const ProcessResult run = runMorphgrid({"run", sceneFile("roof"), "--out", out(), "--validate",
                                            "--set", "output.pictures=false", "--set",
                                            std::string("grid.layer_spacing=") + layerSpacing,
                                            "--set", std::string("solver.method=") + method});
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_EQ(report()["full"]["converged"], true) << method;
    return report();
  };
  const auto thin = weightOf("2", "multigrid"), reference = weightOf("2", "reference"),
             thick = weightOf("6", "multigrid");
  const double energy = reference["full"]["energy"];
  EXPECT_NEAR(thin["full"]["energy"], energy, 1e-6 * std::abs(energy));
  EXPECT_NEAR(thin["weight"]["newtons"], reference["weight"]["newtons"], 1e-9);
  EXPECT_TRUE(reference["weight"]["sag"].is_null());
  EXPECT_GT(thin["weight"]["sag"], 3 * thick["weight"]["sag"].get<double>());
}

TEST_F(Run, WritesAllThatItCanAndTellsTheRest) {
  folder_.write("result/stacked.png/in_the_way", "");
  folder_.write("result/warped.vtu/in_the_way", "");
  std::filesystem::create_directories(out() + "/convergence.csv");
  const ProcessResult run = runMorphgrid({"run", sceneFile("egg_chair"), "--out", out(),
                                          "--validate", "--set", "grid.nodes_long=8", "--set",
                                          "output.width=160", "--set", "output.height=120"});
  EXPECT_EQ(run.exitCode, 5) << run.output;
  EXPECT_THAT(run.output, HasSubstr("3 files could not be written:"));
  for (const char* lost : {"stacked.png", "warped.vtu", "convergence.csv"}) {
    EXPECT_THAT(run.output, HasSubstr(std::string(lost) + ": cannot be written"));
    EXPECT_TRUE(std::filesystem::is_directory(out() + "/" + lost)) << "theirs";
  }
  EXPECT_THAT(run.output, HasSubstr("distance, RMS / max")) << "the table is told all the same";
  EXPECT_EQ(report()["full"]["converged"], true);
  for (const char* file : {"state.safetensors", "warped.glb", "surface.obj", "initial.png",
                           "shrink.png", "target.png"}) {
    EXPECT_TRUE(exists(file)) << file;
  }
}

/// Disks of so many kilobytes: the report comes first, then the rest as far as it goes.
TEST_F(Run, AFullDiskLosesNothingThatFits) {
  for (const char* size : {"size=16k", "size=128k", "size=512k"}) {
    std::filesystem::create_directories(out());
    if (mount("none", out().c_str(), "tmpfs", 0, size) != 0) {
      GTEST_SKIP() << "only root can mount a small disk";
    }
    const ProcessResult run =
        runMorphgrid({"run", sceneFile("egg_chair"), "--out", out(), "--set", "grid.nodes_long=14",
                      "--set", "output.width=640", "--set", "output.height=480"});
    EXPECT_EQ(run.exitCode, 5) << run.output;
    EXPECT_THAT(run.output, ContainsRegex("files could not be written:"));
    EXPECT_EQ(report()["full"]["converged"], true) << size;
    for (const auto& file : std::filesystem::directory_iterator(out())) {
      EXPECT_NE(file.path().filename().string().front(), '.') << "a half file stays: " << file;
    }
    umount(out().c_str());
  }
}

TEST_F(Run, LeavesNoFilesOfTheRunBefore) {
  for (const char* old : {"optimise.csv", "warped.png", "surface.ply", "state.safetensors"}) {
    folder_.write(std::string("result/") + old, "of another design");
  }
  folder_.write("result/notes.txt", "theirs");
  folder_.write("result/.warped.4194305.png", "of a run that was killed");  // No process has it.
  const ProcessResult run =
      runMorphgrid({"run", sceneFile("egg_chair"), "--out", out(), "--quiet", "--set",
                    "grid.nodes_long=6", "--set", "output.pictures=false", "--set",
                    "output.ply=false", "--set", "output.state=false"});
  EXPECT_EQ(run.exitCode, 0) << run.output;
  EXPECT_FALSE(exists("optimise.csv"));
  EXPECT_FALSE(exists("warped.png"));
  EXPECT_FALSE(exists("surface.ply"));
  EXPECT_FALSE(exists("state.safetensors"));
  EXPECT_FALSE(exists(".warped.4194305.png"));
  EXPECT_TRUE(exists("notes.txt"));
}

/// Pictures that take long are dropped; what the report needs is there.
TEST_F(Run, InterruptedWhileItDrawsEndsAtOnce) {
  const ProcessResult run = runMorphgridUntil(
      [&](const std::string&) { return exists("state.safetensors"); },
      {"run", sceneFile("egg_chair"), "--out", out(), "--set", "grid.nodes_long=6", "--set",
       "output.width=8192", "--set", "output.height=8192"},
      SIGTERM);
  EXPECT_EQ(run.exitCode, 130) << run.output;
  EXPECT_THAT(run.output, HasSubstr("interrupted"));
  EXPECT_EQ(report()["full"]["converged"], true);
  EXPECT_FALSE(exists("target.png"));
  for (const auto& file : std::filesystem::directory_iterator(out())) {
    EXPECT_NE(file.path().filename().string().front(), '.') << file;
  }
}

/// What does not fit is told before it is measured, which would take minutes.
TEST_F(Run, MemoryIsLookedAtBeforeTheSurface) {
  for (const std::vector<std::string>& sizes :
       {std::vector<std::string>{"strip", "grid.nodes_u=80000000", "grid.nodes_v=1"},
        {"patch", "grid.nodes_long=15000", "grid.layers=2"}}) {
    const ProcessResult run = runMorphgrid(
        {"run", sceneFile(sizes[0]), "--out", out(), "--set", sizes[1], "--set", sizes[2]});
    EXPECT_EQ(run.exitCode, 2) << run.output;
    EXPECT_THAT(run.output, HasSubstr("would fit: set"));
  }
}

TEST_F(Run, ExplainsTheRowsOfItsTable) {
  const std::vector<std::string> arguments{"check", sceneFile("egg_chair"), "--explain"};
  const ProcessResult explained = runMorphgrid(arguments);
  EXPECT_EQ(explained.exitCode, 0);
  EXPECT_THAT(explained.output, HasSubstr("L_b is a strut's rest length"));
  EXPECT_THAT(explained.output, testing::Not(HasSubstr("inverse design:")));
}

TEST_F(Run, InterruptedWhileItDesignsEndsAndWritesNothing) {
  const ProcessResult run = runMorphgrid(
      {"run", sceneFile("cup"), "--out", out(), "--set", "grid.nodes_long=1500"}, {}, 0.5);
  EXPECT_EQ(run.exitCode, 130) << run.output;
  EXPECT_THAT(run.output, HasSubstr("interrupted before anything was solved"));
  EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(Run, InverseDesignComesCloserAndLeavesItsSteps) {
  const ProcessResult run = runMorphgrid({"run", sceneFile("egg_chair_true"), "--out", out(),
                                          "--validate", "--set", "grid.nodes_long=8", "--set",
                                          "design.optimise=2", "--set", "output.pictures=false"});
  EXPECT_EQ(run.exitCode, 0) << run.output;
  EXPECT_TRUE(exists("optimise.csv"));
  EXPECT_TRUE(exists("optimise.svg"));
  const auto json = report();
  const auto& steps = json["inverse_design"]["steps"];
  EXPECT_LT(steps.back()["rms_percent"].get<double>(), steps.front()["rms_percent"].get<double>());
  EXPECT_NEAR(json["distance_to_target"]["rms_percent"].get<double>(),
              steps.back()["rms_percent"].get<double>(), 1e-3);
  EXPECT_EQ(json["shrink"]["struts_over_limit"], 0);
}

TEST_F(Run, MeshesAreSampledWithRays) {
  const ProcessResult run = runMorphgrid({"run", sceneFile("face"), "--out", out(), "--validate",
                                          "--set", "grid.nodes_long=8", "--set", "output.width=320",
                                          "--set", "output.height=240"});
  EXPECT_EQ(run.exitCode, 0) << run.output;
  EXPECT_TRUE(exists("sampling.png"));
  EXPECT_TRUE(exists("warped.png"));
  const auto mesh = report()["mesh"];
  EXPECT_EQ(mesh["triangles"], 4 * 898);
  EXPECT_EQ(mesh["missed"], 0);
  EXPECT_GT(mesh["largest_jump"].get<double>(), 0);
  EXPECT_GE(mesh["seconds_rays"].get<double>(), 0);
}

TEST_F(Run, DeviceAgreesWithTheReferenceMethod) {
  const std::vector<std::string> common{
      "run",   sceneFile("egg_chair"), "--quiet", "--set", "grid.nodes_long=8",
      "--set", "output.pictures=false"};
  std::vector<std::string> multigrid = common;
  multigrid.insert(multigrid.end(), {"--out", out()});
  ASSERT_EQ(runMorphgrid(multigrid).exitCode, 0);
  const auto onDevice = report();
  std::vector<std::string> reference = common;
  reference.insert(reference.end(), {"--out", out(), "--set", "solver.method=reference"});
  // The reference method without pictures needs no device.
  ASSERT_EQ(runMorphgrid(reference, {"VK_ICD_FILENAMES=/nonexistent"}).exitCode, 0);
  const auto onHost = report();
  EXPECT_NEAR(onDevice["full"]["energy"].get<double>() / onHost["full"]["energy"].get<double>(), 1,
              1e-5);
  EXPECT_NEAR(onDevice["distance_to_target"]["rms_percent"].get<double>(),
              onHost["distance_to_target"]["rms_percent"].get<double>(), 1e-2);
}

TEST_F(Run, StripHasNoTargetAndSaysSo) {
  const ProcessResult run =
      runMorphgrid({"run", sceneFile("strip"), "--out", out(), "--validate", "--set",
                    "grid.nodes_u=10", "--set", "output.width=320", "--set", "output.height=240"});
  EXPECT_EQ(run.exitCode, 0) << run.output;
  EXPECT_TRUE(report()["distance_to_target"].is_null());
  EXPECT_TRUE(report()["measurement"].is_null());
  EXPECT_TRUE(exists("warped.png"));
  EXPECT_FALSE(exists("target.png"));
}

TEST_F(Run, SmallestEigenvalueTellsAMinimumFromASaddle) {
  const std::vector<std::string> common{"run",
                                        sceneFile("egg_chair"),
                                        "--out",
                                        out(),
                                        "--smallest-eigenvalue",
                                        "--set",
                                        "grid.nodes_long=8",
                                        "--set",
                                        "output.pictures=false"};
  std::vector<std::string> onDevice = common;
  onDevice.emplace_back("--validate");
  const ProcessResult run = runMorphgrid(onDevice);
  EXPECT_EQ(run.exitCode, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("minimum: smallest eigenvalue"));
  const auto json = report();
  EXPECT_EQ(json["in_plane"]["smallest_eigenvalue"]["verdict"], "minimum");
  EXPECT_EQ(json["full"]["smallest_eigenvalue"]["verdict"], "minimum");

  std::vector<std::string> reference = common;
  reference.insert(reference.end(), {"--set", "solver.method=reference"});
  ASSERT_EQ(runMorphgrid(reference).exitCode, 0);
  const auto onHost = report();
  EXPECT_EQ(onHost["full"]["smallest_eigenvalue"]["verdict"], "minimum");
  EXPECT_NEAR(json["full"]["smallest_eigenvalue"]["value"].get<double>() /
                  onHost["full"]["smallest_eigenvalue"]["value"].get<double>(),
              1, 0.05);
}

TEST_F(Run, OneLayerStopsAfterTheInPlaneStage) {
  const ProcessResult run = runMorphgrid(
      {"run", sceneFile("patch"), "--out", out(), "--validate", "--set", "grid.layers=1", "--set",
       "grid.nodes_long=6", "--set", "output.width=320", "--set", "output.height=240"});
  EXPECT_EQ(run.exitCode, 0) << run.output;
  EXPECT_TRUE(report()["full"].is_null());
  EXPECT_TRUE(report()["shrink"].is_null());
  EXPECT_TRUE(report()["feasibility"]["close_struts"].is_null());
  EXPECT_TRUE(exists("surface.png"));
  EXPECT_FALSE(exists("shrink.png"));
}

TEST_F(Run, NotConvergedWritesItsResultsAndExitsWith3) {
  const ProcessResult run = runMorphgrid({"run", sceneFile("egg_chair"), "--out", out(), "--set",
                                          "solver.iteration_limit=4", "--set", "output.width=320",
                                          "--set", "output.height=240"});
  EXPECT_EQ(run.exitCode, 3);
  EXPECT_THAT(run.output, HasSubstr("NOT converged: iteration limit"));
  EXPECT_EQ(report()["full"]["converged"], false);
  EXPECT_TRUE(exists("warped.png"));
}

class RunInterrupted : public Run, public testing::WithParamInterface<const char*> {};

TEST_P(RunInterrupted, StopsCleanlyAndWritesItsReport) {
  const ProcessResult run = runMorphgridUntil(
      [](const std::string& output) { return output.find("iterations") != std::string::npos; },
      {"run", sceneFile("egg_chair"), "--out", out(), "--set", "grid.nodes_long=80", "--set",
       "solver.tolerance=1e-15", "--set", "solver.energy_tolerance=0", "--set",
       std::string("solver.method=") + GetParam(), "--set", "output.width=320", "--set",
       "output.height=240"},
      SIGINT);
  EXPECT_EQ(run.exitCode, 130) << run.output;
  EXPECT_THAT(run.output, HasSubstr("interrupted: writing what there is"));
  EXPECT_THAT(run.output, HasSubstr("`morphgrid figures` and the output folder"));
  const auto json = report();
  EXPECT_TRUE(json["in_plane"]["reason"] == "interrupted" ||
              json["full"]["reason"] == "interrupted");
  EXPECT_FALSE(exists("warped.png"));
  EXPECT_EQ(runMorphgrid({"figures", out(), "--quiet"}).exitCode, 3) << "of what was there";
}

INSTANTIATE_TEST_SUITE_P(Methods, RunInterrupted, testing::Values("multigrid", "jacobi"),
                         [](const auto& test) { return std::string(test.param); });

TEST_F(Run, ClampsAreTold) {
  const ProcessResult run = runMorphgrid({"check", sceneFile("egg_chair"), "--set",
                                          "grid.layer_spacing=2", "--set", "grid.nodes_long=2"});
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_THAT(run.output, HasSubstr("Eq. 21"));
  EXPECT_THAT(run.output, HasSubstr("Eq. 23"));
  EXPECT_THAT(run.output, HasSubstr("no grid.curvature_cutoff of 0.5 or more would do"));
  EXPECT_THAT(run.output, HasSubstr("suggested p                         0.29"));
}

TEST_F(Run, BadInputExitsWith2AndLeavesNothing) {
  const ProcessResult run =
      runMorphgrid({"run", sceneFile("egg_chair"), "--out", out(), "--set", "grid.layers=0"});
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_THAT(run.output, HasSubstr("grid.layers"));
  EXPECT_FALSE(std::filesystem::exists(out()));
  EXPECT_EQ(runMorphgrid({"run", "no_such_scene.toml"}).exitCode, 2);
  EXPECT_EQ(runMorphgrid({"dance"}).exitCode, 2);
  EXPECT_EQ(runMorphgrid({}).exitCode, 2);
}

TEST_F(Run, CollapsedPatchIsBadInputAndLeavesNothing) {
  folder_.write("patch.toml",
                "control_points = [\n"
                "[[1,0,0],[1,0,0],[1,0,0],[1,0,0]],\n"
                "[[0,1,0],[1,1,0],[2,1,0],[3,1,0]],\n"
                "[[0,2,0],[1,2,0],[2,2,0],[3,2,0]],\n"
                "[[0,3,0],[1,3,0],[2,3,0],[3,3,0]]]\n");
  const auto scene = folder_.write("collapsed.toml",
                                   "surface = {kind = \"bezier\", patch = \"patch.toml\"}\n"
                                   "grid = {layer_spacing = 0.1}\n");
  const ProcessResult run = runMorphgrid({"run", scene.string(), "--out", out()});
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_THAT(run.output, HasSubstr("collapsed.toml: the u strut at node (0, 0) has no length"));
  EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(Run, FlatPatchStaysFlat) {
  folder_.write("patch.toml",
                "control_points = [\n"
                "[[0,0,0],[1,0,0],[2,0,0],[3,0,0]],\n"
                "[[0,1,0],[1,1,0],[2,1,0],[3,1,0]],\n"
                "[[0,2,0],[1,2,0],[2,2,0],[3,2,0]],\n"
                "[[0,3,0],[1,3,0],[2,3,0],[3,3,0]]]\n");
  const auto scene = folder_.write("flat.toml",
                                   "surface = {kind = \"bezier\", patch = \"patch.toml\"}\n"
                                   "grid = {layer_spacing = 0.1, nodes_long = 5}\n"
                                   "output = {pictures = false}\n");
  const ProcessResult run = runMorphgrid({"run", scene.string(), "--out", out(), "--validate"});
  EXPECT_EQ(run.exitCode, 0) << run.output;
  EXPECT_TRUE(report()["measurement"]["layer_spacing_limit"].is_null());
  EXPECT_LT(report()["distance_to_target"]["max_percent"].get<double>(), 1e-4);
}

TEST_F(Run, UnwritableFolderIsBadInput) {
  const ProcessResult run =
      runMorphgrid({"run", sceneFile("egg_chair"), "--out", "/proc/morphgrid"});
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_THAT(run.output, HasSubstr("/proc/morphgrid"));
  const ProcessResult readOnly =
      runMorphgrid({"run", sceneFile("egg_chair"), "--out", "/proc/self"});
  EXPECT_EQ(readOnly.exitCode, 2) << "before anything is solved";
  EXPECT_THAT(readOnly.output, HasSubstr("--out /proc/self: no file can be written there"));
}

TEST_F(Run, NoDeviceSaysHowToGetOne) {
  const ProcessResult run = runMorphgrid({"devices"}, {"VK_ICD_FILENAMES=/nonexistent"});
  EXPECT_EQ(run.exitCode, 4);
  EXPECT_THAT(run.output, HasSubstr("mesa-vulkan-drivers"));
}

TEST_F(Run, DeviceIsChosenByNameOrIndex) {
  const ProcessResult wrong =
      runMorphgrid({"run", sceneFile("egg_chair"), "--out", out(), "--device", "no such device"});
  EXPECT_EQ(wrong.exitCode, 4);
  EXPECT_THAT(wrong.output, HasSubstr("morphgrid devices"));
  const ProcessResult byIndex =
      runMorphgrid({"run", sceneFile("egg_chair"), "--out", out(), "--device", "0", "--quiet",
                    "--set", "grid.nodes_long=4", "--set", "output.pictures=false"});
  EXPECT_EQ(byIndex.exitCode, 0) << byIndex.output;
  EXPECT_EQ(byIndex.output, "");
}

TEST_F(Run, HelpAndVersion) {
  const ProcessResult help = runMorphgrid({"--help"});
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_THAT(help.output, HasSubstr("Examples:"));
  EXPECT_EQ(runMorphgrid({"--version"}).exitCode, 0);
  EXPECT_THAT(runMorphgrid({"run", "--help"}).output, HasSubstr("--set"));
}

}  // namespace
}  // namespace morphgrid
