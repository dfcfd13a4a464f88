#include <fmt/format.h>

#include "app/command_end.h"
#include "app/command_options.h"
#include "app/commands.h"
#include "app/pipeline.h"
#include "app/propose_files.h"
#include "app/state_argument.h"
#include "core/visible_text.h"
#include "report/judge_run.h"

namespace morphgrid {
namespace {

struct RunArguments {
  SceneArguments scene;
  RunOptions options;
  bool smallestEigenvalue = false;
  bool explains = false;
};

void tellFailure(const RunRecord& record, const RunOptions& options) {
  fmt::print(stderr, "device failure: {}\nwhat was done before is in {}; {}\n",
             *record.deviceFailure, options.outputFolder.string(),
             std::filesystem::exists(options.checkpoint.file)
                 ? fmt::format("go on with --resume {}", options.checkpoint.file.string())
                 : "with --checkpoint FILE a run can go on after that");
}

int run(const RunArguments& arguments) {
  refuseFinishedRun(arguments.scene.scene);
  std::vector<std::string> overrides = arguments.scene.overrides;
  if (arguments.smallestEigenvalue) {
    overrides.emplace_back("solver.smallest_eigenvalue=true");
  }
  const Scene scene = loadScene(
      sceneFor(arguments.scene.scene, arguments.options.outputFolder, arguments.options.quiet),
      overrides);
  RunOptions options = arguments.options;
  if (options.outputFolder.empty()) {
    options.outputFolder = std::filesystem::path("out") / scene.name;
  }
  const RunRecord record = runScene(scene, options);
  if (!options.quiet) {
    logNotices(record);
    showTable(record, arguments.explains);
    fmt::print("results in {}\n", visibleText(options.outputFolder.string()));
    tellVerdict(judgeRun(record));
  }
  if (record.deviceFailure) {
    tellFailure(record, options);
  }
  return conclude(record);
}

}  // namespace

void addRunCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<RunArguments>();
  RunOptions& options = arguments->options;
  CLI::App* command = app.add_subcommand(
      "run", "measure, design, simulate; leave report, pictures and files in a folder");
  addSceneArguments(*command, arguments->scene);
  command->add_option("--out", options.outputFolder, "output folder [out/SCENE]");
  addDeviceOptions(*command, options.device);
  command->add_flag("--smallest-eigenvalue", arguments->smallestEigenvalue,
                    "find out whether the equilibria are minima, as solver.smallest_eigenvalue");
  CLI::Option* checkpoint =
      command->add_option("--checkpoint", options.checkpoint.file,
                          "keep in this file where the run stands, for --resume after a kill or "
                          "Ctrl-C");
  command
      ->add_option("--checkpoint-minutes", options.checkpoint.minutes,
                   "between two checkpoints [5]")
      ->check(within(aboveUpTo(0, 1e6)))
      ->needs(checkpoint);
  command->add_option("--resume", options.resumeFrom,
                      "go on where the run stood that wrote this checkpoint");
  addExplainFlag(*command, arguments->explains);
  addQuietFlag(*command, options.quiet);
  command->callback([&action, arguments] { action = [=] { return run(*arguments); }; });
}

}  // namespace morphgrid
