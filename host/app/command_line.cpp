#include "app/command_line.h"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>

#include "app/figures.h"
#include "app/live_run.h"
#include "app/pipeline.h"
#include "app/state_argument.h"
#include "core/error.h"
#include "core/interrupt.h"
#include "gpu/device_failure.h"
#include "report/report_table.h"
#include "view/viewer.h"

namespace morphgrid {
namespace {

enum ExitCode {
  kConverged = 0,
  kBadInput = 2,
  kNotConverged = 3,
  kDeviceFailure = 4,
  kInterrupted = 130,
};

constexpr const char* kExamples = R"(
Examples:
  morphgrid run scenes/egg_chair.toml
  morphgrid run scenes/iris_petal.toml --out /tmp/petal --set grid.layers=3
  morphgrid run scenes/face.toml --set grid.nodes_long=600 --checkpoint face.checkpoint
  morphgrid run scenes/face.toml --set grid.nodes_long=600 --resume face.checkpoint
  morphgrid check scenes/patch.toml --set grid.layer_spacing=30
  morphgrid figures scenes/egg_chair.toml --animation egg_chair.webp
  morphgrid figures out/egg_chair
  morphgrid view scenes/egg_chair.toml
  morphgrid devices

Exit codes: 0 converged, 2 bad input, 3 not converged (results written),
            4 device failure (what was solved before it is written),
            130 interrupted (results written, if the solver had begun))";

struct Arguments {
  std::filesystem::path scene;
  std::filesystem::path outputFolder;
  std::vector<std::string> overrides;
  DeviceOptions device;
  bool smallestEigenvalue = false;
  bool quiet = false;
  CheckpointOptions checkpoint;
  std::filesystem::path resumeFrom;
  std::filesystem::path sheet;
  FilmOptions film;
  std::optional<double> statisticsSeconds;
};

std::filesystem::path outputFolderOf(const Arguments& arguments, const Scene& scene) {
  return arguments.outputFolder.empty() ? std::filesystem::path("out") / scene.name
                                        : arguments.outputFolder;
}

void logNotices(const RunRecord& record) {
  for (const std::string& notice : record.notices) {
    spdlog::warn(notice);
  }
}

int check(const Arguments& arguments) {
  refuseFinishedRun(arguments.scene);
  const Scene scene = loadScene(arguments.scene, arguments.overrides);
  RunRecord record = checkScene(scene);
  noteInsufficientDevice(scene, record);
  logNotices(record);
  fmt::print("{}", toTable(record));
  return kConverged;
}

int exitCodeOf(const RunRecord& record) {
  const auto ended = [&](const auto& condition) {
    return (record.inPlane && condition(*record.inPlane)) ||
           (record.full && condition(*record.full));
  };
  if (record.deviceFailure) {
    return kDeviceFailure;
  }
  if (ended([](const Equilibrium& e) { return e.reason == StopReason::interrupted; })) {
    return kInterrupted;
  }
  return ended([](const Equilibrium& e) { return !e.converged; }) ? kNotConverged : kConverged;
}

/// Warnings of a run's end, and its exit code.
int conclude(const RunRecord& record) {
  const int exitCode = exitCodeOf(record);
  if (exitCode == kNotConverged) {
    spdlog::warn("not converged; try a higher solver.iteration_limit or a looser solver.tolerance");
  }
  return exitCode;
}

void tellFailure(const RunRecord& record, const std::filesystem::path& folder,
                 const CheckpointOptions& checkpoint) {
  fmt::print(stderr, "device failure: {}\nwhat was done before is in {}; {}\n",
             *record.deviceFailure, folder.string(),
             std::filesystem::exists(checkpoint.file)
                 ? fmt::format("go on with --resume {}", checkpoint.file.string())
                 : "with --checkpoint FILE a run can go on after that");
}

int run(const Arguments& arguments) {
  refuseFinishedRun(arguments.scene);
  std::vector<std::string> overrides = arguments.overrides;
  if (arguments.smallestEigenvalue) {
    overrides.emplace_back("solver.smallest_eigenvalue=true");
  }
  const Scene scene = loadScene(arguments.scene, overrides);
  const auto folder = outputFolderOf(arguments, scene);
  installInterruptHandler();
  const RunRecord record = runScene(scene, {folder, arguments.device, arguments.quiet,
                                            arguments.checkpoint, arguments.resumeFrom});
  if (!arguments.quiet) {
    logNotices(record);
    fmt::print("{}results in {}\n", toTable(record), folder.string());
  }
  if (record.deviceFailure) {
    tellFailure(record, folder, arguments.checkpoint);
  }
  return conclude(record);
}

/// A finished run that had not come to rest.
int concludeState(const RunRecord& record) {
  const Equilibrium& last = record.full ? *record.full : *record.inPlane;
  if (last.converged && record.inPlane->converged) {
    return kConverged;
  }
  spdlog::warn("the run did not converge ({}): this is where it stood", toString(last.reason));
  return kNotConverged;
}

int figures(const Arguments& arguments) {
  const auto state = findState(arguments.scene);
  FiguresOptions options{arguments.sheet, arguments.film, arguments.device, arguments.quiet};
  FiguresRecord record;
  installInterruptHandler();
  if (state) {
    refuseOverrides(arguments.scene, *state, arguments.overrides);
    if (options.sheet.empty()) options.sheet = state->parent_path() / "figures.png";
    record = makeFigures(*state, options);
  } else {
    const Scene scene = loadScene(arguments.scene, arguments.overrides);
    if (options.sheet.empty()) {
      options.sheet = std::filesystem::path("out") / scene.name / "figures.png";
    }
    record = makeFigures(scene, options);
  }
  if (!arguments.quiet) {
    logNotices(record.run);
    fmt::print("{}figures in {}\n", toTable(record.run), options.sheet.string());
  }
  if (record.run.deviceFailure) {
    fmt::print(stderr, "device failure: {}\nwhat was drawn before is in {}\n",
               *record.run.deviceFailure, options.sheet.string());
  }
  const int exitCode = interruptRequested() ? kInterrupted
                       : state              ? concludeState(record.run)
                                            : conclude(record.run);
  return exitCode == kConverged && !record.morphConverged ? kNotConverged : exitCode;
}

int view(const Arguments& arguments) {
  refuseFinishedRun(arguments.scene);
  // What is wrong with the scene is told here rather than in a window.
  const Scene scene = loadScene(arguments.scene, arguments.overrides);
  TargetKeeper targets;
  targets.targetOf(scene);
  const auto folder = outputFolderOf(arguments, scene);
  Window window({.title = scene.title});
  DeviceOptions options = arguments.device;
  options.presentation = Window::presentation();
  RunContext context;
  context.device = std::make_shared<Device>(options);
  installInterruptHandler();
  {
    LiveRun session(context.device, {arguments.scene, arguments.overrides, folder, Window::wake,
                                     std::move(targets)});
    runViewer(*context.device, window, session,
              {.pictureFile = scene.name + "_view.png",
               .statisticsSeconds = arguments.statisticsSeconds});
  }
  context.requireSilence();
  return interruptRequested() ? kInterrupted : kConverged;
}

int printDevices() {
  int index = 0;
  for (const DeviceSummary& device : listDevices()) {
    fmt::print("{}  {} ({}, Vulkan {})\n", index++, device.name, device.type, device.apiVersion);
  }
  return kConverged;
}

void addSceneArguments(CLI::App& command, Arguments& arguments) {
  command
      .add_option(
          "SCENE", arguments.scene,
          "scene file, see docs/scene_format.md; for figures also a finished run: its folder "
          "or its state.safetensors")
      ->required();
  command
      .add_option("--set", arguments.overrides,
                  "override a key of the scene, e.g. --set grid.layers=4; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void addDeviceArguments(CLI::App& command, Arguments& arguments) {
  command.add_option("--device", arguments.device.selection,
                     "Vulkan device, by index or part of its name [the first that will do]");
  command.add_flag("--validate", arguments.device.validation,
                   "run under the Vulkan validation layers; any message is a device failure");
}

CLI::App* addFiguresCommand(CLI::App& app, Arguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "figures", "the pictures of a run on one sheet, with its figures; the morph as an animation");
  addSceneArguments(*command, arguments);
  command->add_option("--out", arguments.sheet, "the sheet, a PNG file [out/SCENE/figures.png]");
  command->add_option("--animation", arguments.film.animation,
                      "the morph as an animated WebP file");
  command->add_option("--frames", arguments.film.framesFolder,
                      "the morph as numbered PNG files in this folder");
  command->add_option("--gltf", arguments.film.gltf, "the morph as a GLB file with an animation");
  command->add_option("--frame-count", arguments.film.frameCount, "frames of the morph [48]")
      ->check(CLI::Range(2, FilmOptions::kMostFrames));
  addDeviceArguments(*command, arguments);
  command->add_flag("--quiet", arguments.quiet, "print errors only");
  return command;
}

CLI::App* addViewCommand(CLI::App& app, Arguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "view", "watch a scene being designed and solved in a window, and turn its knobs");
  addSceneArguments(*command, arguments);
  command->add_option("--out", arguments.outputFolder, "folder of exported files [out/SCENE]");
  addDeviceArguments(*command, arguments);
  command
      ->add_option("--statistics", arguments.statisticsSeconds,
                   "turn the scene and solve it again and again for so many seconds, print how "
                   "smoothly that went, and close")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber);
  return command;
}

int guarded(const std::function<int()>& work) {
  try {
    return work();
  } catch (const InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return kBadInput;
  } catch (const DeviceError& error) {
    fmt::print(stderr, "device failure: {}\n", error.what());
    return kDeviceFailure;
  } catch (const std::system_error& error) {
    if (!isDeviceFailure(error)) {
      throw;
    }
    fmt::print(stderr, "device failure: {}\n", error.what());
    return kDeviceFailure;
  } catch (const Cancelled&) {
    fmt::print(stderr, "interrupted before anything was solved\n");
    return kInterrupted;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "the grid does not fit into memory; ask for fewer nodes\n");
    return kBadInput;
  }
}

}  // namespace

int runCommandLine(int argc, char** argv) {
  spdlog::set_default_logger(spdlog::stderr_color_mt("morphgrid"));
  spdlog::set_pattern("%^%l%$: %v");

  CLI::App app(
      "morphgrid designs and simulates multi-tiered 4D-printed grids: how a flat, multi-layer grid "
      "of "
      "struts must shrink to become a curved surface, and how close it comes.",
      "morphgrid");
  app.set_version_flag("--version", MORPHGRID_VERSION);
  app.footer(kExamples);
  app.require_subcommand(1);

  Arguments arguments;
  CLI::App* runCommand = app.add_subcommand(
      "run", "measure, design, simulate; leave report, pictures and files in a folder");
  addSceneArguments(*runCommand, arguments);
  runCommand->add_option("--out", arguments.outputFolder, "output folder [out/SCENE]");
  addDeviceArguments(*runCommand, arguments);
  runCommand->add_flag("--smallest-eigenvalue", arguments.smallestEigenvalue,
                       "find out whether the equilibria are minima, as solver.smallest_eigenvalue");
  CLI::Option* checkpoint = runCommand->add_option(
      "--checkpoint", arguments.checkpoint.file,
      "keep in this file where the run stands, for --resume after a kill or Ctrl-C");
  runCommand
      ->add_option("--checkpoint-minutes", arguments.checkpoint.minutes,
                   "between two checkpoints [5]")
      ->check(CLI::PositiveNumber)
      ->needs(checkpoint);
  runCommand->add_option("--resume", arguments.resumeFrom,
                         "go on where the run stood that wrote this checkpoint");
  runCommand->add_flag("--quiet", arguments.quiet, "print errors only");
  CLI::App* checkCommand =
      app.add_subcommand("check", "read, measure and design; print the table, solve nothing");
  addSceneArguments(*checkCommand, arguments);
  CLI::App* figuresCommand = addFiguresCommand(app, arguments);
  CLI::App* viewCommand = addViewCommand(app, arguments);
  CLI::App* devicesCommand = app.add_subcommand("devices", "list the Vulkan devices");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kConverged : kBadInput;
  }
  return guarded([&] {
    if (devicesCommand->parsed()) {
      return printDevices();
    }
    if (viewCommand->parsed()) {
      return view(arguments);
    }
    if (figuresCommand->parsed()) {
      return figures(arguments);
    }
    return checkCommand->parsed() ? check(arguments) : run(arguments);
  });
}

}  // namespace morphgrid
