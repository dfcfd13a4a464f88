#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>

#include "tests/render/pixels.h"
#include "tests/support/dome_scene.h"
#include "tests/support/folders.h"
#include "tests/view/desktop.h"
#include "view/window.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

// Devices and fonts differ in the pixels along edges, and runs in the seconds that are told.
constexpr double kLargestMeanDifference = 2;
constexpr double kOther = 0.05;  // Another style moves the mean by more, the same one by less.
constexpr int kLooks = 60;       // Until the window must have changed.

/// The program in a window of a desktop of its own, under the validation layers: any message of
/// theirs is exit code 4.
class ViewerWindow : public testing::Test {
 protected:
  std::unique_ptr<BackgroundProgram> start(const std::vector<std::string>& more = {}) {
    return start(more, desktop_.folder().write("dome.toml", kDomeScene));
  }
  std::unique_ptr<BackgroundProgram> start(const std::vector<std::string>& more,
                                           const std::filesystem::path& scene) {
    std::vector<std::string> command = {
        binaryFolder() / "morphgrid", "view", scene, "--validate", "--out",
        desktop_.folder() / "out"};
    command.insert(command.end(), more.begin(), more.end());
    return std::make_unique<BackgroundProgram>(
        command, std::vector<std::string>{"DISPLAY=" + desktop_.display()},
        desktop_.folder() / "viewer.log");
  }

  void expectQuit(BackgroundProgram& viewer) {
    desktop_.press("ctrl+q");
    EXPECT_EQ(viewer.exitCode(), 0) << viewer.output();
  }

  /// Gives the keyboard to the window with this title: no window manager does.
  void focus(const std::string& title) {
    const std::string id = desktop_.awaitWindow(title);
    ASSERT_NE(id, "") << title;
    desktop_.run("xdotool windowfocus --sync " + id);
  }

  Image shot() { return readPng(desktop_.screenshot("shot").string()); }

  /// When the window has come to rest: what stays is drawn finer after a while.
  Image stillShot() {
    Image last = shot();
    for (int n = 0, still = 0; n < kLooks && still < 2; ++n) {
      desktop_.run("sleep 0.5");
      const Image next = shot();
      still = differenceOf(next, last).mean < kOther ? still + 1 : 0;
      last = next;
    }
    return last;
  }

  /// Whether the window comes to differ from `image`.
  bool awaitOtherThan(const Image& image) {
    for (int n = 0; n < kLooks; ++n) {
      if (differenceOf(shot(), image).mean > kOther) {
        return true;
      }
      desktop_.run("sleep 0.2");
    }
    return false;
  }

  /// After these keys were handled: keys are handled in their order, so the stages that are shown
  /// afterwards tell.
  Image stillShotAfter(const std::string& keys) {
    desktop_.press(keys + " 3");
    EXPECT_NE(desktop_.awaitWindow("^Dome, initial:"), "") << keys;
    desktop_.press("6");
    EXPECT_NE(desktop_.awaitWindow("^Dome, warped:"), "") << keys;
    return stillShot();
  }

  /// golden: of which other picture; empty: its own.
  void expectGolden(const std::string& name, const std::string& other = "") {
    const std::filesystem::path shot = desktop_.screenshot(name);
    const std::filesystem::path golden =
        sourceFolder() / "tests/golden" / ((other.empty() ? name : other) + ".png");
    const std::filesystem::path actual = binaryFolder() / (name + "_actual.png");
    if (std::filesystem::exists(golden)) {
      const Image a = readPng(shot.string());
      const Image b = readPng(golden.string());
      if (a.width == b.width && a.height == b.height &&
          differenceOf(a, b).mean <= kLargestMeanDifference) {
        return;
      }
    }
    std::filesystem::copy_file(shot, actual, std::filesystem::copy_options::overwrite_existing);
    ADD_FAILURE() << "the window looks otherwise; look at " << actual
                  << "; if this is how it should look, copy it to " << golden;
  }

  Desktop desktop_;
};

TEST_F(ViewerWindow, StepsThroughTheStagesByKeys) {
  const auto viewer = start();
  focus("^Dome, warped: at rest");
  for (const auto& [key, stage] :
       {std::pair("3", "initial"), {"4", "in-plane"}, {"5", "stacked"}, {"7", "surface"}}) {
    desktop_.press(key);
    EXPECT_NE(desktop_.awaitWindow(fmt::format("^Dome, {}:", stage)), "") << stage;
  }
  desktop_.press("1");  // There is no target: nothing changes.
  desktop_.press("6");
  EXPECT_NE(desktop_.awaitWindow("^Dome, warped:"), "");
  desktop_.run("sleep 1");  // A picture that stays is drawn finer.
  expectGolden("viewer_window");
  expectQuit(*viewer);
}

TEST_F(ViewerWindow, OpensAFinishedRunThatLooksAsItsSceneDoes) {
  const std::filesystem::path scene = desktop_.folder().write("dome.toml", kDomeScene);
  const std::filesystem::path run = desktop_.folder() / "run";
  BackgroundProgram solver({binaryFolder() / "morphgrid", "run", scene, "--out", run, "--set",
                            "output.pictures=false", "--quiet"},
                           {}, desktop_.folder() / "run.log");
  ASSERT_EQ(solver.exitCode(), 0) << solver.output();
  std::filesystem::remove(scene);
  const auto viewer = start({}, run);
  focus("^Dome, warped: at rest .*, as stored");
  desktop_.run("sleep 1");  // A picture that stays is drawn finer.
  expectGolden("viewer_stored_run", "viewer_window");
  desktop_.press("r");
  EXPECT_NE(desktop_.awaitWindow("^Dome, warped: at rest .* s$"), "")
      << desktop_.run("xdotool search --name '^Dome' getwindowname");
  desktop_.press("ctrl+r");
  EXPECT_NE(desktop_.awaitWindow("^Dome, warped: at rest .*, as stored"), "");
  desktop_.press("ctrl+s");
  expectQuit(*viewer);
  EXPECT_TRUE(std::filesystem::exists(run / "dome_edited.toml"));
}

TEST_F(ViewerWindow, ADamagedStateIsToldWithoutAWindow) {
  desktop_.folder().write("run/state.safetensors", "rubbish");
  const auto viewer = start({}, desktop_.folder() / "run");
  EXPECT_EQ(viewer->exitCode(), 2);
  EXPECT_THAT(viewer->output(), HasSubstr("is no state of morphgrid; run the scene again"));
}

// What the automatic style chooses depends on how long frames take, and is tested where they are
// given (DetailGovernor); here it is the one between tubes and lines. A slow machine draws a
// picture that stays finer later, so pictures of one style are only nearer to each other.
TEST_F(ViewerWindow, DrawsStrutsInTheStyleThatTheUserChooses) {
  const auto viewer = start();
  focus("^Dome, warped: at rest");
  const Image lines = stillShotAfter("s");
  const Image ribbons = stillShotAfter("s");
  const Image tubes = stillShotAfter("s");
  EXPECT_GT(differenceOf(ribbons, lines).mean, kOther);
  EXPECT_GT(differenceOf(tubes, ribbons).mean, kOther);
  EXPECT_GT(differenceOf(tubes, lines).mean, kOther);
  const Image linesAgain = stillShotAfter("s s");
  EXPECT_LT(differenceOf(linesAgain, lines).mean, differenceOf(linesAgain, tubes).mean / 2);
  EXPECT_LT(differenceOf(linesAgain, lines).mean, differenceOf(linesAgain, ribbons).mean / 2);
  expectQuit(*viewer);
}

TEST_F(ViewerWindow, TurnsAKnobSavesTheSceneAndUndoes) {
  const auto viewer = start();
  focus("^Dome, warped: at rest");
  desktop_.click(190, 401);  // The "+" of the layers.
  desktop_.awaitWindow("^Dome, (in-plane|warped): (in plane|full)");
  EXPECT_NE(desktop_.awaitWindow("^Dome, warped: at rest"), "");
  desktop_.press("ctrl+s");
  desktop_.press("ctrl+e");
  desktop_.press("ctrl+z");
  desktop_.awaitWindow("^Dome, (in-plane|warped): (in plane|full)");
  EXPECT_NE(desktop_.awaitWindow("^Dome, warped: at rest"), "");
  expectQuit(*viewer);
  std::ostringstream saved;
  saved << std::ifstream(desktop_.folder() / "dome_edited.toml").rdbuf();
  EXPECT_THAT(saved.str(), HasSubstr("layers = 4"));
}

// There is no target and no conformal sheet: their colourings are left out.
TEST_F(ViewerWindow, ColorsAFrameByEachFigureThatItHas) {
  const auto viewer = start({"--set", "material.model=frame"});
  focus("^Dome, warped: at rest");
  const std::filesystem::path choice = desktop_.folder() / "choice.png";
  const auto shownChoice = [&] {  // What the panel says.
    desktop_.run("sleep 1");
    desktop_.run(fmt::format("convert {} -crop 260x18+10+292 +repage {}",
                             desktop_.screenshot("all").string(), choice.string()));
    return readPng(choice.string()).rgba;
  };
  const auto strain = shownChoice();
  auto last = strain;
  for (const char* next : {"shrink", "layer", "bending strain", "joint rotation"}) {
    const Image before = shot();
    desktop_.press("c");
    EXPECT_TRUE(awaitOtherThan(before)) << next;
    const auto now = shownChoice();
    EXPECT_TRUE(now != last && now != strain) << next;
    last = now;
  }
  desktop_.press("c");
  EXPECT_TRUE(shownChoice() == strain);
  expectQuit(*viewer);
}

TEST_F(ViewerWindow, ClosesWhileItSolves) {
  const auto viewer = start({"--set", "grid.nodes_u=60", "--set", "grid.nodes_v=60"});
  focus("^Dome, .*: (in plane|full)");
  expectQuit(*viewer);
}

TEST_F(ViewerWindow, ClosesWhileItDesigns) {
  const auto viewer =
      start({"--set", "grid.nodes_long=1500"}, sourceFolder() / "scenes" / "cup.toml");
  focus("^Cup, target: designing");
  expectQuit(*viewer);
}

TEST_F(ViewerWindow, IsMinimisedAndComesBack) {
  const BackgroundProgram windowManager({"9wm"}, {"DISPLAY=" + desktop_.display()},
                                        desktop_.folder() / "9wm.log");
  const auto viewer = start();
  focus("^Dome, warped: at rest");
  desktop_.run("xdotool search --name '^Dome' windowminimize --sync");
  EXPECT_EQ(desktop_.run("xdotool search --onlyvisible --name '^Dome'"), "");
  desktop_.run("xdotool search --name '^Dome' windowmap --sync windowfocus --sync");
  desktop_.press("3");
  EXPECT_NE(desktop_.awaitWindow("^Dome, initial:"), "");
  expectQuit(*viewer);
}

TEST_F(ViewerWindow, ReadsTheSceneAgain) {
  const auto viewer = start();
  focus("^Dome, warped: at rest");
  std::string changed = kDomeScene;
  changed.replace(changed.find("Dome"), 4, "Vault");
  desktop_.folder().write("dome.toml", changed);
  desktop_.press("ctrl+r");
  EXPECT_NE(desktop_.awaitWindow("^Vault, warped: at rest"), "");
  expectQuit(*viewer);
}

TEST_F(ViewerWindow, FollowsItsSize) {
  const auto viewer = start();
  focus("^Dome, warped: at rest");
  for (const char* size : {"500 300", "1 1", "1200 700", "80 600"}) {
    desktop_.run(fmt::format("xdotool search --name '^Dome' windowsize --sync {}", size));
  }
  for (const char* how : {"windowunmap", "windowmap"}) {
    desktop_.run(fmt::format("xdotool search --name '^Dome' {} --sync", how));
  }
  focus("^Dome");
  expectQuit(*viewer);
}

TEST_F(ViewerWindow, ACtrlCInTheTerminalClosesIt) {
  const auto viewer = start();
  focus("^Dome, warped: at rest");
  viewer->signal(SIGINT);
  EXPECT_EQ(viewer->exitCode(), 130) << viewer->output();
}

TEST_F(ViewerWindow, WithoutADisplaySaysWhatToDo) {
  const std::filesystem::path scene = desktop_.folder().write("dome.toml", kDomeScene);
  BackgroundProgram viewer({binaryFolder() / "morphgrid", "view", scene}, {"DISPLAY="},
                           desktop_.folder() / "viewer.log");
  EXPECT_EQ(viewer.exitCode(), 4);
  EXPECT_THAT(viewer.output(), HasSubstr("`morphgrid run`"));
}

TEST_F(ViewerWindow, AMissingDriverIsNotTakenForAMissingDisplay) {
  const std::filesystem::path scene = desktop_.folder().write("dome.toml", kDomeScene);
  BackgroundProgram viewer({binaryFolder() / "morphgrid", "view", scene},
                           {"DISPLAY=" + desktop_.display(), "VK_ICD_FILENAMES=/nonexistent"},
                           desktop_.folder() / "viewer.log");
  EXPECT_EQ(viewer.exitCode(), 4);
  EXPECT_THAT(viewer.output(), HasSubstr("apt-get install mesa-vulkan-drivers"));
  EXPECT_THAT(viewer.output(), testing::Not(HasSubstr("DISPLAY")));
}

TEST(WindowInput, KeysStayUntilTheyAreHandled) {
  const Desktop desktop;
  ASSERT_EQ(setenv("DISPLAY", desktop.display().c_str(), 1), 0);
  {
    Window window({.title = "Keys"});
    desktop.run("xdotool windowfocus --sync " + desktop.awaitWindow("^Keys"));
    while (window.handleEvents(0.5)) {
    }
    EXPECT_FALSE(window.handleEvents(0));
    desktop.press("r");
    // It is there when the wait for it ends at once, and still there when another wait was in vain.
    EXPECT_TRUE(window.handleEvents(0));
    while (window.handleEvents(0.5)) {
    }
    ASSERT_EQ(window.keys().size(), 1);
    EXPECT_EQ(window.keys().front().key, GLFW_KEY_R);
    window.forgetKeys();
    EXPECT_TRUE(window.keys().empty());
  }
  unsetenv("DISPLAY");
}

}  // namespace
}  // namespace morphgrid
