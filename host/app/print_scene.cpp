#include "app/print_scene.h"

#include <fmt/format.h>

#include "app/restored_run.h"
#include "app/simulate_laid.h"
#include "app/simulate_scene.h"
#include "core/cancellation.h"
#include "core/create_folder.h"
#include "core/error.h"
#include "print/write_print_files.h"
#include "report/judge_run.h"

namespace morphgrid {
namespace {

/// The scene's, with the enlargement that is asked for.
PrintTools toolsOf(const Scene& scene, const PrintOptions& options) {
  if (!scene.print) {
    throw InputError(fmt::format(
        "{}: there is no [print]: name a printer and a material there, or with --printer and "
        "--material",
        scene.file.string()));
  }
  PrintTools tools = scene.print->tools;
  tools.request.enlargement = options.enlargement;
  return tools;
}

RunContext contextFor(Scene& scene, const SceneDesign& designed, const PrintOptions& options) {
  scene.pictures.enabled = false;
  RunContext context = createRunContext(scene, designed, options.device, {}, nullptr);
  if (!context.device) {  // What is laid is always simulated on one.
    context.attempt([&] { context.device = std::make_shared<Device>(options.device); });
  }
  return context;
}

PrintOutcome print(const Scene& scene, const SceneDesign& designed, Simulation simulation,
                   RunContext& context, const PrintOptions& options) {
  const PrintTools tools = toolsOf(scene, options);
  const StrutGrid& grid = simulation.stage.grid;
  simulation.stage.onDevice.reset();  // Its memory is for what is laid.
  PrintRecord record{.plan =
                         planPrint(scene.name, grid, tools.printer, tools.material, tools.request)};
  context.attempt([&] {
    record.shape =
        simulateLaid(scene, designed.targets, simulation.stage, record.plan.rest, *context.device);
  });
  context.requireSilence();
  if (scene.solve.stopRequested()) {
    throw Cancelled();
  }
  RunRecord& run = simulation.record;
  if (context.failure) run.deviceFailure = context.failure;
  run.print = assessmentOf(record.plan);
  record.verdict = judgeRun(run, record.shape ? &*record.shape : nullptr);
  createFolder(options.outputFolder, "--out " + options.outputFolder.string());
  writePrintFiles(record, options.outputFolder, options.isPlain);
  return {std::move(record), std::move(run)};
}

}  // namespace

PrintOutcome printScene(Scene scene, const PrintOptions& options) {
  toolsOf(scene, options);  // Before anything is solved.
  const SceneDesign designed = designScene(scene);
  RunContext context = contextFor(scene, designed, options);
  CheckpointKeeper keeper({}, {});
  Simulation simulation = simulateScene(scene, designed, context, keeper, options.quiet);
  return print(scene, designed, std::move(simulation), context, options);
}

PrintOutcome printRun(const std::filesystem::path& state, const PrintOptions& options) {
  RestoredRun run = restoreRun(state, options.overrides);
  RunContext context = contextFor(run.scene, run.designed, options);
  return print(run.scene, run.designed, std::move(run.simulation), context, options);
}

}  // namespace morphgrid
