#include <fmt/format.h>

#include "app/command_end.h"
#include "app/command_options.h"
#include "app/commands.h"
#include "app/figures.h"
#include "app/propose_files.h"
#include "app/scene.h"
#include "app/state_argument.h"
#include "core/interrupt.h"
#include "report/judge_run.h"
#include "report/report_table.h"

namespace morphgrid {
namespace {

struct FiguresArguments {
  SceneArguments scene;
  FiguresOptions options;
};

FiguresRecord figuresOfRun(const std::filesystem::path& state, FiguresOptions& options) {
  if (options.sheet.empty()) {
    options.sheet = state.parent_path() / "figures.png";
  }
  return makeFigures(state, options);
}

FiguresRecord figuresOfScene(const SceneArguments& arguments, FiguresOptions& options) {
  const Scene scene = loadScene(
      sceneFor(arguments.scene, options.sheet.parent_path(), options.quiet), arguments.overrides);
  if (options.sheet.empty()) {
    options.sheet = std::filesystem::path("out") / scene.name / "figures.png";
  }
  return makeFigures(scene, options);
}

int makeFiguresOf(const FiguresArguments& arguments) {
  const auto state = findState(arguments.scene.scene);
  if (state) {
    refuseOverrides(arguments.scene.scene, *state, arguments.scene.overrides);
  }
  FiguresOptions options = arguments.options;
  installInterruptHandler();
  const FiguresRecord record =
      state ? figuresOfRun(*state, options) : figuresOfScene(arguments.scene, options);
  if (!options.quiet) {
    logNotices(record.run);
    fmt::print("{}figures in {}\n", toTable(record.run), options.sheet.string());
    tellVerdict(judgeRun(record.run));
  }
  if (record.run.deviceFailure) {
    fmt::print(stderr, "device failure: {}\nwhat was drawn before is in {}\n",
               *record.run.deviceFailure, options.sheet.string());
  }
  const int exitCode = interruptRequested() ? kInterrupted
                       : state              ? concludeFinished(record.run)
                                            : conclude(record.run);
  return exitCode == kConverged && !record.morphConverged ? kNotConverged : exitCode;
}

}  // namespace

void addFiguresCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<FiguresArguments>();
  FiguresOptions& options = arguments->options;
  CLI::App* command = app.add_subcommand(
      "figures", "the pictures of a run on one sheet, with its figures; the morph as an animation");
  addSceneOrRunArguments(*command, arguments->scene);
  command->add_option("--out", options.sheet,
                      "the sheet, a PNG file [out/SCENE/figures.png, or in the run's folder]");
  command->add_option("--animation", options.film.animation, "the morph as an animated WebP file");
  command->add_option("--frames", options.film.framesFolder,
                      "the morph as numbered PNG files in this folder");
  command->add_option("--gltf", options.film.gltf, "the morph as a GLB file with an animation");
  command->add_option("--frame-count", options.film.frameCount, "frames of the morph [48]")
      ->check(CLI::Range(2, FilmOptions::kMostFrames));
  addDeviceOptions(*command, options.device);
  addQuietFlag(*command, options.quiet);
  command->callback([&action, arguments] { action = [=] { return makeFiguresOf(*arguments); }; });
}

}  // namespace morphgrid
