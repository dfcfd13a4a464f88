#include "app/print_scene.h"

#include "app/restored_run.h"
#include "app/simulate_laid.h"
#include "app/simulate_scene.h"
#include "core/cancellation.h"
#include "core/create_folder.h"
#include "print/write_print_files.h"

namespace morphgrid {
namespace {

/// What is to be printed with what; read before anything is solved.
struct PrintTools {
  Printer printer;
  PrintMaterial material;
};

PrintTools readTools(const PrintOptions& options) {
  return {readPrinter(options.printer), readPrintMaterial(options.material)};
}

RunContext contextFor(const Scene& scene, const SceneDesign& designed,
                      std::shared_ptr<Device> device, const PrintOptions& options) {
  RunContext context = createRunContext(scene, designed, std::move(device), {}, nullptr);
  if (!context.device) {  // What is laid is always simulated on one.
    context.attempt([&] { context.device = std::make_shared<Device>(options.device); });
  }
  return context;
}

PrintOutcome print(const Scene& scene, const SceneDesign& designed, Simulation simulation,
                   RunContext& context, const PrintTools& tools, const PrintOptions& options) {
  const StrutGrid& grid = simulation.stage.grid;
  simulation.stage.onDevice.reset();  // Its memory is for what is laid.
  PrintRecord record{
      .plan = planPrint(scene.name, grid, tools.printer, tools.material, options.request)};
  context.attempt([&] {
    record.shape =
        simulateLaid(scene, designed.targets, simulation.stage, record.plan.rest, *context.device);
  });
  context.requireSilence();
  if (scene.solve.stopRequested()) {
    throw Cancelled();
  }
  createFolder(options.outputFolder, "--out " + options.outputFolder.string());
  writePrintFiles(record, options.outputFolder, options.isPlain);
  RunRecord& run = simulation.record;
  if (context.failure) run.deviceFailure = context.failure;
  return {std::move(record), std::move(run)};
}

}  // namespace

PrintOutcome printScene(Scene scene, const PrintOptions& options) {
  const PrintTools tools = readTools(options);
  scene.pictures.enabled = false;
  const std::shared_ptr<Device> device = deviceFor(scene, options.device, options.quiet);
  const SceneDesign designed = designScene(scene, roomOn(device, scene));
  RunContext context = contextFor(scene, designed, device, options);
  CheckpointKeeper keeper({}, {});
  Simulation simulation = simulateScene(scene, designed, context, keeper, options.quiet);
  return print(scene, designed, std::move(simulation), context, tools, options);
}

PrintOutcome printRun(const std::filesystem::path& state, const PrintOptions& options) {
  const PrintTools tools = readTools(options);
  RestoredRun run = restoreRun(state);
  run.scene.pictures.enabled = false;
  RunContext context = contextFor(run.scene, run.designed,
                                  deviceFor(run.scene, options.device, options.quiet), options);
  return print(run.scene, run.designed, std::move(run.simulation), context, tools, options);
}

}  // namespace morphgrid
