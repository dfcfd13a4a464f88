#include "app/command_line.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>

#include "app/command_end.h"
#include "app/commands.h"
#include "app/guarded_action.h"
#include "core/on_interrupt.h"

namespace morphgrid {
namespace {

constexpr const char* kExamples = R"(
Examples:
  morphgrid run model.obj
  morphgrid new model.obj --size 150 --nodes 24
  morphgrid run scenes/egg_chair.toml
  morphgrid run scenes/iris_petal.toml --out /tmp/petal --set grid.layers=3
  morphgrid run scenes/face.toml --set grid.nodes_long=600 --checkpoint face.checkpoint
  morphgrid run scenes/face.toml --set grid.nodes_long=600 --resume face.checkpoint
  morphgrid check scenes/patch.toml --set grid.layer_spacing=30
  morphgrid figures scenes/egg_chair.toml --animation egg_chair.webp
  morphgrid figures out/egg_chair
  morphgrid print out/egg_chair --printer printers/prusa_mk4.toml --material materials/pla_0.08.toml
  morphgrid calibrate print --printer printers/prusa_mk4.toml --material materials/pla_0.08.toml
  morphgrid view scenes/egg_chair.toml
  morphgrid view out/egg_chair
  morphgrid devices

Exit codes: 0 converged, 2 bad input, or what no printer could lay (nothing written),
            3 not converged, or not printable as it is (results written),
            4 device failure or out of memory (what was solved before it is written),
            5 not all files, or not standard output, could be written (each is told),
            130 interrupted (report and state written, if the solver of a run had begun))";

int parseAndRun(int argc, char** argv) {
  spdlog::set_default_logger(spdlog::stderr_color_mt("morphgrid"));
  spdlog::set_pattern("%^%l%$: %v");

  CLI::App app(
      "morphgrid designs and simulates multi-tiered 4D-printed grids: how a flat, multi-layer grid "
      "of struts must shrink to become a curved surface, and how close it comes.",
      "morphgrid");
  app.set_version_flag("--version", MORPHGRID_VERSION);
  app.footer(kExamples);
  app.require_subcommand(1);

  Action action;
  addNewCommand(app, action);
  addRunCommand(app, action);
  addCheckCommand(app, action);
  addFiguresCommand(app, action);
  addPrintCommand(app, action);
  addCalibrateCommand(app, action);
  addViewCommand(app, action);
  addDevicesCommand(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kConverged : kBadInput;
  }
  installInterruptHandler();
  const OnInterrupt ending(InterruptAct::end, "interrupted: nothing more is written");
  return action();
}

}  // namespace

int runCommandLine(int argc, char** argv) {
  reserveStandardStreams();
  return withOutputWritten(runGuarded([&] { return parseAndRun(argc, argv); }));
}

}  // namespace morphgrid
