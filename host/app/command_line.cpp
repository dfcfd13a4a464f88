#include "app/command_line.h"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>

#include "app/command_end.h"
#include "app/commands.h"
#include "core/cancellation.h"
#include "core/error.h"
#include "gpu/device_failure.h"

namespace morphgrid {
namespace {

constexpr const char* kExamples = R"(
Examples:
  morphgrid run scenes/egg_chair.toml
  morphgrid run scenes/iris_petal.toml --out /tmp/petal --set grid.layers=3
  morphgrid run scenes/face.toml --set grid.nodes_long=600 --checkpoint face.checkpoint
  morphgrid run scenes/face.toml --set grid.nodes_long=600 --resume face.checkpoint
  morphgrid check scenes/patch.toml --set grid.layer_spacing=30
  morphgrid figures scenes/egg_chair.toml --animation egg_chair.webp
  morphgrid figures out/egg_chair
  morphgrid print out/egg_chair --printer printers/prusa_mk4.toml --material materials/pla_0.08.toml
  morphgrid view scenes/egg_chair.toml
  morphgrid view out/egg_chair
  morphgrid devices

Exit codes: 0 converged, 2 bad input, 3 not converged, or not printable (results written),
            4 device failure (what was solved before it is written),
            130 interrupted (results written, if the solver had begun))";

int guarded(const Action& action) {
  try {
    return action();
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
      "of struts must shrink to become a curved surface, and how close it comes.",
      "morphgrid");
  app.set_version_flag("--version", MORPHGRID_VERSION);
  app.footer(kExamples);
  app.require_subcommand(1);

  Action action;
  addRunCommand(app, action);
  addCheckCommand(app, action);
  addFiguresCommand(app, action);
  addPrintCommand(app, action);
  addViewCommand(app, action);
  addDevicesCommand(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kConverged : kBadInput;
  }
  return guarded(action);
}

}  // namespace morphgrid
