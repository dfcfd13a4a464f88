#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "app/command_end.h"
#include "app/command_options.h"
#include "app/commands.h"
#include "app/print_scene.h"
#include "app/state_argument.h"

namespace morphgrid {
namespace {

struct PrintArguments {
  SceneArguments scene;
  PrintOptions options;
};

PrintOutcome printStored(const std::filesystem::path& state, PrintOptions& options) {
  if (options.outputFolder.empty()) {
    options.outputFolder = state.parent_path() / "print";
  }
  return printRun(state, options);
}

PrintOutcome printAnew(const SceneArguments& arguments, PrintOptions& options) {
  const Scene scene = loadScene(arguments.scene, arguments.overrides);
  if (options.outputFolder.empty()) {
    options.outputFolder = std::filesystem::path("out") / scene.name / "print";
  }
  return printScene(scene, options);
}

int printGrid(const PrintArguments& arguments) {
  const auto state = findState(arguments.scene.scene);
  if (state) {
    refuseOverrides(arguments.scene.scene, *state, arguments.scene.overrides);
  }
  PrintOptions options = arguments.options;
  const PrintOutcome outcome =
      state ? printStored(*state, options) : printAnew(arguments.scene, options);
  const PrintRecord& record = outcome.record;
  if (!options.quiet) {
    if (!state) logNotices(outcome.run);
    for (const std::string& notice : printNotices(record)) spdlog::warn(notice);
    fmt::print("{}G-code in {}\n", printTable(record), options.outputFolder.string());
  }
  if (outcome.run.deviceFailure) {
    fmt::print(stderr, "device failure: {}\nwhat is laid was not simulated to the end\n",
               *outcome.run.deviceFailure);
  }
  const int exitCode =
      state && !outcome.run.deviceFailure ? concludeFinished(outcome.run) : conclude(outcome.run);
  const bool isInRange = record.plan.figures.outOfRange.empty();
  return exitCode == kConverged && !isInRange ? kNotConverged : exitCode;
}

void addRequestOptions(CLI::App& command, PrintRequest& request) {
  command
      .add_option("--scale", request.scale,
                  "mm of the finished object per unit of the scene [the largest that fits]")
      ->check(CLI::PositiveNumber);
  command
      .add_option(
          "--enlarge", request.enlargement,
          "how much larger than the run's sheet it is printed [by the fewest struts out of range]")
      ->check(CLI::Range(0.5, 2.0));
  command
      .add_option("--pin", request.pin,
                  "diameter of the pins through hubs and tubes, mm [1.75, filament]")
      ->check(CLI::Range(0.2, 20.0));
  command
      .add_option("--clearance", request.clearance, "by how much wider their holes are, mm [0.2]")
      ->check(CLI::Range(0.0, 5.0));
  command.add_option("--loops", request.loops, "rings of a hub beside each other [2]")
      ->check(CLI::Range(1, 10));
  command
      .add_option("--passes", request.passes,
                  "of a strut on top of each other [as the material has it]")
      ->check(CLI::Range(1, 1000));
}

}  // namespace

void addPrintCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<PrintArguments>();
  PrintOptions& options = arguments->options;
  CLI::App* command = app.add_subcommand(
      "print", "G-code for each tier of a designed grid, and whether it can be printed");
  addSceneOrRunArguments(*command, arguments->scene);
  command->add_option("--printer", options.printer, "a printer file, e.g. printers/prusa_mk4.toml")
      ->required();
  command
      ->add_option("--material", options.material, "a material file, e.g. materials/pla_0.08.toml")
      ->required();
  addRequestOptions(*command, options.request);
  command->add_option("--out", options.outputFolder,
                      "output folder [out/SCENE/print, or print in the run's folder]");
  command->add_flag("--plain", options.isPlain, "leave out the comments that name struts");
  addDeviceOptions(*command, options.device);
  addQuietFlag(*command, options.quiet);
  command->callback([&action, arguments] { action = [=] { return printGrid(*arguments); }; });
}

}  // namespace morphgrid
