#include <fmt/format.h>

#include "app/command_end.h"
#include "app/command_options.h"
#include "app/commands.h"
#include "app/figures.h"
#include "app/propose_files.h"
#include "app/scene.h"
#include "app/state_argument.h"
#include "report/judge_run.h"

namespace morphgrid {
namespace {

struct FiguresArguments {
  SceneArguments scene;
  FiguresOptions options;
  bool explains = false;
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

/// What was written, frames as one.
std::vector<std::string> writtenLines(const std::vector<std::filesystem::path>& written,
                                      const FiguresOptions& options) {
  std::vector<std::string> lines;
  int frames = 0;
  for (const std::filesystem::path& file : written) {
    if (file == options.sheet) {
      lines.push_back(fmt::format("figures in {}", file.string()));
    } else if (file == options.film.animation || file == options.film.gltf) {
      lines.push_back(fmt::format("the morph in {}", file.string()));
    } else {
      ++frames;
    }
  }
  if (frames > 0) {
    lines.push_back(fmt::format("{} frames in {}", frames, options.film.framesFolder.string()));
  }
  return lines;
}

int makeFiguresOf(const FiguresArguments& arguments) {
  const auto state = findState(arguments.scene.scene);
  if (state) {
    refuseOverrides(arguments.scene.scene, *state, arguments.scene.overrides);
  }
  FiguresOptions options = arguments.options;
  const FiguresRecord record =
      state ? figuresOfRun(*state, options) : figuresOfScene(arguments.scene, options);
  if (!options.quiet) {
    logNotices(record.run);
    showTable(record.run, arguments.explains);
    for (const std::string& line : writtenLines(record.written, options)) fmt::print("{}\n", line);
    tellVerdict(judgeRun(record.run));
  }
  if (record.run.deviceFailure) {
    fmt::print(stderr, "device failure: {}\nwhat was drawn before is in {}\n",
               *record.run.deviceFailure, options.sheet.string());
  }
  const int exitCode = state ? concludeFinished(record.run) : conclude(record.run);
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
  addExplainFlag(*command, arguments->explains);
  addQuietFlag(*command, options.quiet);
  command->callback([&action, arguments] { action = [=] { return makeFiguresOf(*arguments); }; });
}

}  // namespace morphgrid
