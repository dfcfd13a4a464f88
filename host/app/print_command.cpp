#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <toml++/toml.h>

#include <sstream>

#include "app/command_end.h"
#include "app/command_options.h"
#include "app/commands.h"
#include "app/print_scene.h"
#include "app/state_argument.h"
#include "core/interrupt.h"

namespace morphgrid {
namespace {

/// Options that stand for keys of [print].
struct PrintKeys {
  std::filesystem::path printer;
  std::filesystem::path material;
  std::optional<double> scale, pin, clearance;
  std::optional<int> loops, passes;
};

struct PrintArguments {
  SceneArguments scene;
  PrintKeys keys;
  PrintOptions options;
};

/// As --set has them.
std::vector<std::string> overridesOf(const PrintKeys& keys) {
  std::vector<std::string> overrides;
  const auto add = [&](const char* name, const auto& value) {
    if (value) overrides.push_back(fmt::format("print.{}={}", name, *value));
  };
  const auto addFile = [&](const char* name, const std::filesystem::path& file) {
    if (file.empty()) return;
    std::ostringstream quoted;
    quoted << toml::value<std::string>(std::filesystem::absolute(file).string());
    overrides.push_back(fmt::format("print.{}={}", name, quoted.str()));
  };
  addFile("printer", keys.printer);
  addFile("material", keys.material);
  add("scale", keys.scale);
  add("pin", keys.pin);
  add("clearance", keys.clearance);
  add("loops", keys.loops);
  add("passes", keys.passes);
  return overrides;
}

PrintOutcome printStored(const std::filesystem::path& state, PrintOptions& options) {
  if (options.outputFolder.empty()) {
    options.outputFolder = state.parent_path() / "print";
  }
  return printRun(state, options);
}

PrintOutcome printAnew(const SceneArguments& arguments, PrintOptions& options) {
  std::vector<std::string> overrides = arguments.overrides;
  overrides.insert(overrides.end(), options.overrides.begin(), options.overrides.end());
  const Scene scene = loadScene(arguments.scene, overrides);
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
  options.overrides = overridesOf(arguments.keys);
  installInterruptHandler();
  const PrintOutcome outcome =
      state ? printStored(*state, options) : printAnew(arguments.scene, options);
  const PrintRecord& record = outcome.record;
  if (!options.quiet) {
    if (!state) logNotices(outcome.run);
    for (const std::string& notice : printNotices(record)) spdlog::warn(notice);
    fmt::print("{}G-code in {}\n", printTable(record), options.outputFolder.string());
    tellVerdict(record.verdict);
  }
  if (outcome.run.deviceFailure) {
    fmt::print(stderr, "device failure: {}\nwhat is laid was not simulated to the end\n",
               *outcome.run.deviceFailure);
  }
  const int exitCode =
      state && !outcome.run.deviceFailure ? concludeFinished(outcome.run) : conclude(outcome.run);
  return exitCode == kConverged && !record.verdict.isGood() ? kNotConverged : exitCode;
}

void addKeyOptions(CLI::App& command, PrintKeys& keys) {
  command.add_option("--printer", keys.printer,
                     "a printer file, e.g. printers/prusa_mk4.toml [the scene's print.printer, as "
                     "the others have their keys]");
  command.add_option("--material", keys.material, "a material file, e.g. materials/pla_0.08.toml");
  command
      .add_option("--scale", keys.scale,
                  "mm of the finished object per unit of the scene [the largest that fits]")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--pin", keys.pin,
                  "diameter of the pins through hubs and tubes, mm [1.75, filament]")
      ->check(CLI::Range(0.2, 20.0));
  command.add_option("--clearance", keys.clearance, "by how much wider their holes are, mm [0.2]")
      ->check(CLI::Range(0.0, 5.0));
  command.add_option("--loops", keys.loops, "rings of a hub beside each other [2]")
      ->check(CLI::Range(1, 10));
  command
      .add_option("--passes", keys.passes,
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
  addKeyOptions(*command, arguments->keys);
  command
      ->add_option("--enlarge", options.enlargement,
                   "how much larger than the run's sheet it is printed [1, or what leaves the "
                   "fewest struts out of range]")
      ->check(CLI::Range(0.5, 2.0));
  command->add_option("--out", options.outputFolder,
                      "output folder [out/SCENE/print, or print in the run's folder]");
  command->add_flag("--plain", options.isPlain, "leave out the comments that name struts");
  addDeviceOptions(*command, options.device);
  addQuietFlag(*command, options.quiet);
  command->callback([&action, arguments] { action = [=] { return printGrid(*arguments); }; });
}

}  // namespace morphgrid
