#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <toml++/toml.h>

#include <sstream>

#include "app/command_end.h"
#include "app/command_options.h"
#include "app/commands.h"
#include "app/print_scene.h"
#include "app/propose_files.h"
#include "app/state_argument.h"
#include "core/error.h"
#include "core/read_file.h"
#include "surface/load_mesh.h"

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

/// The scene itself; of a mesh one that is proposed for what it is printed with.
std::filesystem::path sceneToPrint(const PrintArguments& arguments) {
  const std::filesystem::path& scene = arguments.scene.scene;
  const PrintKeys& keys = arguments.keys;
  if (!isMeshName(scene)) return scene;
  if (keys.printer.empty() || keys.material.empty()) {
    throw InputError(
        fmt::format("{}: is a mesh, which says nothing of its print: name --printer "
                    "and --material",
                    scene.string()));
  }
  ProposalRequest request{.mesh = scene, .printerFile = keys.printer};
  readPrinter(keys.printer);  // Its faults are told before the mesh is looked at.
  setMaterialFile(request, keys.material);
  return proposedScene(request, arguments.options.outputFolder, arguments.options.quiet);
}

PrintOutcome printAnew(const PrintArguments& arguments, PrintOptions& options) {
  std::vector<std::string> overrides = arguments.scene.overrides;
  overrides.insert(overrides.end(), options.overrides.begin(), options.overrides.end());
  const Scene scene = loadScene(sceneToPrint(arguments), overrides);
  if (options.outputFolder.empty()) {
    options.outputFolder = std::filesystem::path("out") / scene.name / "print";
  }
  return printScene(scene, options);
}

/// Scenes would tell of them as of --set.
void requireFile(const char* option, const std::filesystem::path& file) {
  if (file.empty()) return;
  if (const auto why = whyUnreadable(file)) {
    throw InputError(fmt::format("{} {}: cannot be read: {}", option, file.string(), *why));
  }
}

int printGrid(const PrintArguments& arguments) {
  requireFile("--printer", arguments.keys.printer);
  requireFile("--material", arguments.keys.material);
  const auto state = findState(arguments.scene.scene);
  if (state) {
    refuseOverrides(arguments.scene.scene, *state, arguments.scene.overrides);
  }
  PrintOptions options = arguments.options;
  options.overrides = overridesOf(arguments.keys);
  const PrintOutcome outcome = state ? printStored(*state, options) : printAnew(arguments, options);
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
      ->check(within(fromTo(1e-6, 1e6)));
  addHubOptions(command, keys);
}

void addToleranceOptions(CLI::App& command, std::optional<ToleranceRequest>& tolerance) {
  const auto request = std::make_shared<ToleranceRequest>();
  const auto set = [request, &tolerance] { tolerance = *request; };
  CLI::Option* share =
      command
          .add_option_function<double>(
              "--tolerance",
              [=](double value) {
                request->share = value;
                set();
              },
              "what becomes of prints whose shrinks are off by this share, e.g. 0.1")
          ->check(within(fromTo(1e-6, 0.5)))
          ->type_name("SHARE");
  command
      .add_option_function<int>(
          "--samples",
          [=](int value) {
            request->samples = value;
            set();
          },
          "prints of each kind of random error [40]")
      ->check(CLI::Range(1, 100000))
      ->needs(share);
  command
      .add_option_function<std::uint64_t>(
          "--seed",
          [=](std::uint64_t value) {
            request->seed = value;
            set();
          },
          "of random errors: the same seed, the same prints [1]")
      ->check(wholeNumber())
      ->needs(share);
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
      ->check(within(fromTo(0.5, 2)));
  command->add_option("--out", options.outputFolder,
                      "output folder [out/SCENE/print, or print in the run's folder]");
  addToleranceOptions(*command, options.tolerance);
  command->add_flag("--plain", options.files.isPlain, "leave out the comments that name struts");
  command->add_flag("--stl", options.files.stl,
                    "also write each tier as a solid, for looking and for slicers");
  command->add_flag("--3mf", options.files.threeMf, "the same, all tiers in one file");
  addDeviceOptions(*command, options.device);
  addQuietFlag(*command, options.quiet);
  command->callback([&action, arguments] { action = [=] { return printGrid(*arguments); }; });
}

}  // namespace morphgrid
