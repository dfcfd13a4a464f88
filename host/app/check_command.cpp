#include <fmt/format.h>

#include "app/command_end.h"
#include "app/command_options.h"
#include "app/commands.h"
#include "app/pipeline.h"
#include "app/state_argument.h"
#include "report/report_table.h"

namespace morphgrid {
namespace {

int check(const SceneArguments& arguments) {
  refuseFinishedRun(arguments.scene);
  const Scene scene = loadScene(arguments.scene, arguments.overrides);
  RunRecord record = checkScene(scene);
  noteInsufficientDevice(scene, record);
  logNotices(record);
  fmt::print("{}", toTable(record));
  return kConverged;
}

}  // namespace

void addCheckCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<SceneArguments>();
  CLI::App* command =
      app.add_subcommand("check", "read, measure and design; print the table, solve nothing");
  addSceneArguments(*command, *arguments);
  command->callback([&action, arguments] { action = [=] { return check(*arguments); }; });
}

}  // namespace morphgrid
