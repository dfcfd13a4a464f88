#include "app/figures.h"

#include <fmt/format.h>

#include <fstream>
#include <map>

#include "app/draw_run.h"
#include "app/output_files.h"
#include "app/restored_run.h"
#include "core/atomic_file.h"
#include "core/create_folder.h"
#include "core/error.h"
#include "core/on_interrupt.h"
#include "render/font.h"
#include "report/report_table.h"

namespace morphgrid {
namespace {

using DrawnPanels = std::map<std::string, Panel>;

/// In the paper's order, with the target before it; what was not drawn is left out.
constexpr const char* kPanelNames[] = {"target", "sampling", "initial", "in_plane", "stacked",
                                       "shrink", "warped",   "surface", "distance"};

void requireExtension(const char* option, const std::filesystem::path& path,
                      const char* extension) {
  if (!path.empty() && path.extension() != extension) {
    throw InputError(
        fmt::format("{} {}: the name must end in {}", option, path.string(), extension));
  }
}

void requireNames(const FiguresOptions& options) {
  requireExtension("--out", options.sheet, ".png");
  requireExtension("--animation", options.film.animation, ".webp");
  requireExtension("--gltf", options.film.gltf, ".glb");
}

void requireMorph(const Scene& scene, const SceneDesign& designed, const FilmOptions& film) {
  if (film.wanted() && designed.design.layers < 2) {
    throw InputError(fmt::format(
        "{}: a morph takes at least 2 layers: --frames, --animation and --gltf need a higher "
        "grid.layers",
        scene.file.string()));
  }
}

/// Refuses what cannot be written before the solve.
void requireWritable(const std::filesystem::path& file) {
  if (file.has_parent_path()) {
    createFolder(file.parent_path(), file.parent_path().string());
  }
  const PendingFile probe(file);
  if (std::filesystem::is_directory(file) || !std::ofstream(probe.path())) {
    throw InputError(fmt::format("{}: no file can be written there", file.string()));
  }
}

void requireWritable(const FiguresOptions& options) {
  for (const auto& file : {options.sheet, options.film.animation, options.film.gltf}) {
    if (!file.empty()) {
      requireWritable(file);
    }
  }
  if (!options.film.framesFolder.empty()) {
    requireWritable(options.film.framesFolder / "frame_0000.png");
  }
}

SheetOptions sheetFor(const Scene& scene) {
  const std::string figure =
      scene.published ? fmt::format(", beside the paper's {}", scene.published->figure) : "";
  return {.title = scene.title + figure,
          .panelWidth = scene.pictures.width,
          .panelHeight = scene.pictures.height};
}

std::vector<Panel> panelsOf(DrawnPanels drawn, const RunRecord& record, const SheetOptions& sheet) {
  constexpr std::size_t kTables = 1;
  if ((drawn.size() + kTables) % static_cast<std::size_t>(sheet.columns) == 1) {
    drawn.erase("shrink");  // It would bring about a row of a single panel.
  }
  std::vector<Panel> panels;
  for (const char* name : kPanelNames) {
    if (const auto panel = drawn.find(name); panel != drawn.end()) {
      panels.push_back(std::move(panel->second));
    }
  }
  panels.push_back({drawText(toFigureTable(record), sheet), "figures", {}});
  return panels;
}

FilmRecord film(const Scene& scene, const SceneDesign& designed, RunContext& context,
                Simulation& simulation, const FiguresOptions& options, OutputFiles& files) {
  FilmRecord record;
  if (!options.film.wanted()) return record;
  const OnInterrupt ending(InterruptAct::end,
                           "interrupted: the sheet is written, not all that shows the morph");
  Stage& stage = simulation.stage;
  context.attempt(
      [&] { stage.onDevice = std::make_shared<DeviceGrid>(*context.device, stage.grid); });
  if (!stage.onDevice) return record;
  context.attempt([&] {
    record =
        filmMorph(scene, designed, *context.device, simulation, options.film, files, options.quiet);
  });
  return record;
}

/// simulate(RunContext&) gives the Simulation. sampling: of a mesh; may be null.
template <typename Simulate>
FiguresRecord makeSheet(const Scene& scene, const SceneDesign& designed,
                        const MeshSampling* sampling, const std::shared_ptr<Device>& device,
                        const FiguresOptions& options, const Simulate& simulate) {
  requireMorph(scene, designed, options.film);
  const SheetOptions sheet = sheetFor(scene);
  sheetSize(sheet, std::size(kPanelNames));  // Refuses a sheet too large before the solve,
  Font::findMono();                          // and so is a missing font.
  DrawnPanels drawn;
  RunContext context =
      createRunContext(scene, designed, device, panelPicture(sheet),
                       [&](const std::string& name, const Panel& panel) { drawn[name] = panel; });
  requireWritable(options);

  Simulation simulation = simulate(context);
  drawRun(scene, designed, sampling, simulation, context);
  OutputFiles files({}, true);
  files.writeAt(options.sheet, [&](const auto& path) {
    writePng(path, composeSheet(panelsOf(std::move(drawn), simulation.record, sheet), sheet));
  });
  const FilmRecord filmed = film(scene, designed, context, simulation, options, files);
  context.requireSilence();
  RunRecord& record = simulation.record;
  if (context.failure) {
    record.deviceFailure = context.failure;
  }
  record.notices.insert(record.notices.end(), filmed.notices.begin(), filmed.notices.end());
  record.lostFiles = files.lost();
  return {std::move(record), filmed.converged, files.written()};
}

}  // namespace

FiguresRecord makeFigures(Scene scene, const FiguresOptions& options) {
  requireNames(options);
  scene.pictures.enabled = true;
  const std::shared_ptr<Device> device = deviceFor(scene, options.device, options.quiet);
  const SceneDesign designed = designScene(scene, roomOn(device, scene));
  const MeshSampling* sampling = designed.target ? designed.target->meshSampling() : nullptr;
  return makeSheet(scene, designed, sampling, device, options, [&](RunContext& context) {
    CheckpointKeeper keeper({}, {});
    return simulateScene(scene, designed, context, keeper, options.quiet);
  });
}

FiguresRecord makeFigures(const std::filesystem::path& state, const FiguresOptions& options) {
  requireNames(options);
  RestoredRun run = restoreRun(state);
  run.scene.pictures.enabled = true;
  const std::shared_ptr<Device> device = deviceFor(run.scene, options.device, options.quiet);
  return makeSheet(run.scene, run.designed, run.sampling ? &*run.sampling : nullptr, device,
                   options, [&](RunContext&) { return std::move(run.simulation); });
}

}  // namespace morphgrid
