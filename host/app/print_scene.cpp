#include "app/print_scene.h"

#include <fmt/format.h>

#include "app/assess_tolerance.h"
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

RunContext contextFor(const Scene& scene, const SceneDesign& designed,
                      std::shared_ptr<Device> device, const PrintOptions& options) {
  RunContext context = createRunContext(scene, designed, std::move(device), {}, nullptr);
  if (!context.device) {  // What is laid is always simulated on one.
    context.attempt([&] { context.device = std::make_shared<Device>(options.device); });
  }
  return context;
}

struct DesignKnowledge {
  DesignBounds bounds;
  std::vector<std::string> notices;
};

/// What a finished run's design knew of what it is printed with now.
DesignBounds boundsOf(const RestoredRun& run) {
  DesignBounds bounds = designBoundsOf(run.scene);
  const std::optional<PrintAssessment>& then = run.simulation.record.print;
  bounds.hasPrint = then.has_value();
  if (!then || !run.scene.print) return bounds;
  const ScenePrint& now = *run.scene.print;
  std::string keys;
  for (const std::string& tool : changedTools(*then, now.tools)) {
    const auto& file = tool == "printer" ? now.printerFile : now.materialFile;
    keys += fmt::format(" --set print.{}={}", tool, file.string());
  }
  if (!keys.empty()) bounds.anew = fmt::format("morphgrid run {}{}", run.sceneFile.string(), keys);
  return bounds;
}

/// That the run knew another printer, or another material, or the same before it was changed.
std::vector<std::string> noticesOnTools(const RestoredRun& run) {
  std::vector<std::string> notices;
  const std::optional<PrintAssessment>& then = run.simulation.record.print;
  if (!then || !run.scene.print) return notices;
  const PrintTools& now = run.scene.print->tools;
  for (const std::string& tool : changedTools(*then, now)) {
    const bool isPrinter = tool == "printer";
    const std::string& before = isPrinter ? then->printer : then->material;
    const std::string& name = isPrinter ? now.printer.name : now.material.name;
    notices.push_back(
        before == name ? fmt::format("the {} {} has changed since the run, whose design does "
                                     "not know of it",
                                     tool, name)
                       : fmt::format("the run was designed for another {}, {}, and does not know "
                                     "of {}",
                                     tool, before, name));
  }
  return notices;
}

PrintOutcome print(const Scene& scene, const SceneDesign& designed, Simulation simulation,
                   const DesignKnowledge& knowledge, RunContext& context,
                   const PrintOptions& options) {
  const PrintTools tools = toolsOf(scene, options);
  const StrutGrid& grid = simulation.stage.grid;
  simulation.stage.onDevice.reset();  // Its memory is for what is laid.
  PrintRecord record{
      .plan = planPrint(scene.name, grid, tools.printer, tools.material, tools.request),
      .notices = knowledge.notices};
  context.attempt([&] {
    record.shape =
        simulateLaid(scene, designed.targets, simulation.stage, record.plan.rest, *context.device);
    if (options.tolerance) {
      record.tolerance = assessTolerance(scene, designed.targets, simulation.stage, record.plan,
                                         *options.tolerance, options.quiet, *context.device);
    }
  });
  context.requireSilence();
  if (scene.solve.stopRequested()) {
    throw Cancelled();
  }
  RunRecord& run = simulation.record;
  if (context.failure) run.deviceFailure = context.failure;
  run.print = assessmentOf(record.plan, tools, knowledge.bounds);
  record.verdict = judgeRun(run, record.shape ? &*record.shape : nullptr);
  createFolder(options.outputFolder, "--out " + options.outputFolder.string());
  writePrintFiles(record, options.outputFolder, options.files);
  return {std::move(record), std::move(run)};
}

}  // namespace

PrintOutcome printScene(Scene scene, const PrintOptions& options) {
  toolsOf(scene, options);  // Before anything is solved.
  scene.pictures.enabled = false;
  const std::shared_ptr<Device> device = deviceFor(scene, options.device, options.quiet);
  const SceneDesign designed = designScene(scene, roomOn(device, scene));
  RunContext context = contextFor(scene, designed, device, options);
  CheckpointKeeper keeper({}, {});
  Simulation simulation = simulateScene(scene, designed, context, keeper, options.quiet);
  return print(scene, designed, std::move(simulation), {designBoundsOf(scene), {}}, context,
               options);
}

PrintOutcome printRun(const std::filesystem::path& state, const PrintOptions& options) {
  RestoredRun run = restoreRun(state, options.overrides);
  run.scene.pictures.enabled = false;
  RunContext context = contextFor(run.scene, run.designed,
                                  deviceFor(run.scene, options.device, options.quiet), options);
  const DesignKnowledge knowledge{boundsOf(run), noticesOnTools(run)};
  return print(run.scene, run.designed, std::move(run.simulation), knowledge, context, options);
}

}  // namespace morphgrid
