// The figures command as a user runs it.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/mount.h>

#include <filesystem>
#include <regex>

#include "tests/app/subprocess.h"
#include "tests/export/gltf_files.h"
#include "tests/render/webp_files.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;
using Arguments = std::vector<std::string>;

class Figures : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_ / "made" / name; }
  bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }

  /// Runs `figures` on a small grid, with small pictures.
  ProcessResult figures(const std::string& scene, const Arguments& more,
                        const Arguments& environment = {}, double interruptAfterSeconds = 0) const {
    Arguments arguments{"figures", sourceFolder() / "scenes" / (scene + ".toml"),
                        "--out",   path("sheet.png"),
                        "--set",   "output.width=160",
                        "--set",   "output.height=120"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runMorphgrid(arguments, environment, interruptAfterSeconds);
  }

  /// The size of a PNG file in pixels, from its header.
  std::pair<int, int> sizeOf(const std::string& name) const {
    const std::string bytes = readFile(path(name));
    const auto number = [&](std::size_t at) {
      int value = 0;
      for (std::size_t n = 0; n < 4; ++n) {
        value = 256 * value + static_cast<unsigned char>(bytes.at(at + n));
      }
      return value;
    };
    return {number(16), number(20)};
  }

  TemporaryFolder folder_;
};

TEST_F(Figures, ShowTheMorphInAllFormats) {
  std::filesystem::create_directories(path("frames"));
  for (const char* old : {"frame_0004.png", "frame_0005.png", "frame_0006.png", "frame_0008.png"}) {
    folder_.write(std::string("made/frames/") + old, "of a longer film");
  }
  const ProcessResult run =
      figures("egg_chair",
              {"--validate", "--set", "grid.nodes_long=6", "--frame-count", "5", "--frames",
               path("frames"), "--animation", path("morph.webp"), "--gltf", path("morph.glb")});
  ASSERT_EQ(run.exitCode, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("paper Fig. 4"));
  EXPECT_THAT(run.output, HasSubstr("figures in " + path("sheet.png")));
  // Three rows of three panels under the title.
  const auto [width, height] = sizeOf("sheet.png");
  EXPECT_EQ(width, 3 * 160);
  EXPECT_GT(height, 3 * 120);
  EXPECT_LT(height, 4 * 120);

  EXPECT_EQ(sizeOf("frames/frame_0000.png"), std::pair(160, 120));
  EXPECT_EQ(sizeOf("frames/frame_0004.png"), std::pair(160, 120));
  EXPECT_FALSE(exists("frames/frame_0005.png"));
  EXPECT_FALSE(exists("frames/frame_0006.png"));
  EXPECT_TRUE(exists("frames/frame_0008.png")) << "no film of this program has gaps";

  const std::vector<WebpFrame> frames = readWebp(path("morph.webp"));
  ASSERT_EQ(frames.size(), 5);
  EXPECT_EQ(frames.front().image.width, 160);
  EXPECT_EQ(frames.front().image.height, 120);
  EXPECT_EQ(frames.back().endMilliseconds, 500 + 3000 + 1500);

  const tinygltf::Model model = loadGltf(path("morph.glb"));
  const tinygltf::AnimationSampler& sampler = model.animations.at(0).samplers.at(0);
  const Eigen::MatrixXf seconds = values<float>(model, sampler.input, 1);
  Eigen::RowVectorXf wanted(7);
  wanted << 0, 0.5, 1.25, 2, 2.75, 3.5, 5;
  EXPECT_EQ(seconds, wanted);
  EXPECT_EQ(onlyPrimitive(model, "struts").targets.size(), 4);
}

TEST_F(Figures, OfGridsWithoutATargetAreASheetToo) {
  const ProcessResult run =
      figures("node", {"--validate", "--quiet", "--gltf", path("morph.glb"), "--frame-count", "2"});
  ASSERT_EQ(run.exitCode, 0) << run.output;
  EXPECT_EQ(run.output, "");
  EXPECT_EQ(sizeOf("sheet.png").first, 3 * 160);
  EXPECT_LT(sizeOf("sheet.png").second, 3 * 120);
  EXPECT_TRUE(exists("morph.glb"));
}

TEST_F(Figures, MeshesShowTheirSampling) {
  const ProcessResult run = figures("face", {"--validate", "--set", "grid.nodes_long=8"});
  ASSERT_EQ(run.exitCode, 0) << run.output;
  EXPECT_GT(sizeOf("sheet.png").second, 3 * 120);
  EXPECT_LT(sizeOf("sheet.png").second, 4 * 120);
}

TEST_F(Figures, BadInputExitsWith2AndLeavesNothing) {
  const std::string file = folder_.write("file", "");
  const std::vector<std::pair<Arguments, const char*>> cases{
      {{"--animation", path("morph.gif")}, "--animation .*morph.gif: the name must end in .webp"},
      {{"--gltf", path("morph.gltf")}, "--gltf .*morph.gltf: the name must end in .glb"},
      {{"--frames", path("f"), "--set", "grid.layers=1"}, "a morph takes at least 2 layers"},
      {{"--frame-count", "1"}, "frame-count.*2"},
      {{"--set", "grid.layers=0"}, "grid.layers"},
      {{"--set", "output.width=8192", "--set", "output.height=8192"}, "9 panels of 8192 x 8192"},
  };
  for (const auto& [arguments, message] : cases) {
    const ProcessResult run = figures("egg_chair", arguments);
    EXPECT_EQ(run.exitCode, 2) << run.output;
    EXPECT_TRUE(std::regex_search(run.output, std::regex(message))) << run.output;
    EXPECT_FALSE(exists(""));
  }
  const ProcessResult noFolder = figures("egg_chair", {"--animation", file + "/morph.webp"});
  EXPECT_EQ(noFolder.exitCode, 2) << noFolder.output;
  EXPECT_THAT(noFolder.output, HasSubstr(file + ": the folder cannot be made"));
  std::filesystem::create_directories(path("folder.glb"));
  const ProcessResult noFile = figures("egg_chair", {"--gltf", path("folder.glb")});
  EXPECT_EQ(noFile.exitCode, 2) << noFile.output;
  EXPECT_THAT(noFile.output, HasSubstr("folder.glb: no file can be written there"));
  EXPECT_FALSE(exists("sheet.png"));
}

TEST_F(Figures, StepsThatDoNotConvergeAreTold) {
  const ProcessResult run =
      figures("egg_chair", {"--set", "grid.nodes_long=6", "--set", "solver.iteration_limit=1",
                            "--animation", path("morph.webp"), "--frame-count", "3"});
  EXPECT_EQ(run.exitCode, 3) << run.output;
  EXPECT_THAT(run.output, HasSubstr("2 of the morph's 2 steps did not converge"));
  EXPECT_THAT(run.output, HasSubstr("the slow morph ends in another equilibrium"));
  EXPECT_TRUE(exists("sheet.png"));
  EXPECT_TRUE(exists("morph.webp"));
}

TEST_F(Figures, InterruptedLeavesTheSheetThatIsThereAndNothingHalf) {
  const std::vector<std::pair<const char*, std::string>> moments{
      {"sheet.png", "interrupted: the sheet is written, not all that shows the morph"},
      {"", "interrupted: nothing more is written"}};
  for (const auto& [there, told] : moments) {
    const ProcessResult run = runMorphgridUntil(
        [&, name = std::string(there)](const std::string& output) {
          return name.empty() ? output.find("iterations") != std::string::npos : exists(name);
        },
        {"figures", sourceFolder() / "scenes/egg_chair.toml", "--out", path("sheet.png"),
         "--animation", path("morph.webp"), "--frame-count", "1000", "--set", "output.width=160",
         "--set", "output.height=120", "--set", "grid.nodes_long=60", "--set",
         std::string("solver.tolerance=") + (*there ? "1e-9" : "1e-15"), "--set",
         std::string("solver.energy_tolerance=") + (*there ? "1e-9" : "0")},
        SIGINT);
    EXPECT_EQ(run.exitCode, 130) << run.output;
    EXPECT_THAT(run.output, HasSubstr(told));
    EXPECT_EQ(exists("sheet.png"), *there != 0);
    EXPECT_FALSE(exists("morph.webp"));
    for (const auto& file : std::filesystem::directory_iterator(path(""))) {
      EXPECT_NE(file.path().filename().string().front(), '.') << file;
    }
    std::filesystem::remove(path("sheet.png"));
  }
}

TEST_F(Figures, AFullDiskUnderOneFileKeepsNoOtherFromIt) {
  std::filesystem::create_directories(path("small"));
  if (mount("none", path("small").c_str(), "tmpfs", 0, "size=4k") != 0) {
    GTEST_SKIP() << "only root can mount a small disk";
  }
  const ProcessResult run =
      figures("egg_chair",
              {"--set", "grid.nodes_long=6", "--animation", path("small/morph.webp"), "--frames",
               path("small/frames"), "--gltf", path("morph.glb"), "--frame-count", "3"});
  umount(path("small").c_str());
  EXPECT_EQ(run.exitCode, 5) << run.output;
  EXPECT_THAT(run.output, HasSubstr("2 files could not be written:"));
  EXPECT_THAT(run.output, HasSubstr("small/morph.webp: cannot be written"));
  EXPECT_THAT(run.output, HasSubstr("small/frames/frame_0000.png: cannot be written"));
  EXPECT_TRUE(exists("sheet.png"));
  EXPECT_TRUE(exists("morph.glb"));
}

TEST_F(Figures, NamesAllFilesThatItWrote) {
  const ProcessResult run = runMorphgrid(
      {"figures", sourceFolder() / "scenes/egg_chair.toml", "--out", path("sheet.png"), "--set",
       "grid.nodes_long=6", "--set", "output.width=160", "--set", "output.height=120", "--frames",
       path("frames"), "--gltf", path("morph.glb"), "--frame-count", "3"});
  EXPECT_EQ(run.exitCode, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("the morph in " + path("morph.glb")));
  EXPECT_THAT(run.output, HasSubstr("3 frames in " + path("frames")));
}

TEST_F(Figures, LostDeviceLeavesTheSheet) {
  const ProcessResult run =
      figures("egg_chair", {"--set", "grid.nodes_long=6", "--animation", path("morph.webp")},
              {"VK_INSTANCE_LAYERS=VK_LAYER_MORPHGRID_failing_device",
               "VK_LAYER_PATH=" + (binaryFolder() / "layers").string(),
               "MORPHGRID_FAILING_DEVICE_SUBMITS=50"});
  EXPECT_EQ(run.exitCode, 4) << run.output;
  EXPECT_THAT(run.output, HasSubstr("what was drawn before is in " + path("sheet.png")));
  EXPECT_TRUE(exists("sheet.png"));
  EXPECT_FALSE(exists("morph.webp"));
}

}  // namespace
}  // namespace morphgrid
