#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "app/command_end.h"
#include "app/command_options.h"
#include "app/commands.h"
#include "app/draw_preview.h"
#include "app/list_levers.h"
#include "app/pipeline.h"
#include "app/propose_files.h"
#include "app/state_argument.h"
#include "core/create_folder.h"
#include "core/error.h"
#include "surface/load_mesh.h"

namespace morphgrid {
namespace {

/// The mesh from all sides: to where a run would put its pictures. Says what of it should be seen.
void showSides(const Scene& scene, bool draws) {
  const MeshSides sides = lookAtMesh(scene);
  for (const std::string& notice : adviseOnSides(sides.sights)) {
    spdlog::warn(notice);
  }
  if (!draws) return;
  const std::filesystem::path folder = std::filesystem::path("out") / scene.name;
  std::vector<PreviewSide> views = previewSides(sides.sights);
  views.insert(views.begin(), {Sight{.name = "along +x"}, std::get<MeshRequest>(scene.surface).box,
                               "as configured: rays along +x"});
  try {
    createFolder(folder, folder.string());
    drawPreview(folder / kPreviewFile, scene.title, sides.mesh, views);
    fmt::print("the mesh from all sides in {}\n", (folder / kPreviewFile).string());
    std::fflush(stdout);
  } catch (const DeviceError& error) {
    spdlog::warn("no {}: {}", kPreviewFile, error.what());
  } catch (const InputError& error) {  // Nobody has asked a check to write.
    spdlog::warn("no {}: {}", kPreviewFile, error.what());
  }
}

struct CheckArguments : SceneArguments {
  bool explains = false;
};

int check(const CheckArguments& arguments) {
  refuseFinishedRun(arguments.scene);
  const bool isProposed = isMeshName(arguments.scene);
  const Scene scene = loadScene(sceneFor(arguments.scene, {}, false), arguments.overrides);
  if (!isProposed && std::holds_alternative<MeshRequest>(scene.surface)) {
    showSides(scene, scene.pictures.enabled);
  }
  const SceneDesign designed = designScene(scene);
  RunRecord record = recordOf(scene, designed);
  noteInsufficientDevice(scene, record);
  if (!isProposed) {
    for (const std::string& lever : listLevers(scene, designed)) {
      record.notices.push_back(lever);
    }
  }
  logNotices(record);
  showTable(record, arguments.explains);
  return kConverged;
}

}  // namespace

void addCheckCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command = app.add_subcommand(
      "check",
      "read, measure and design; print the table and what would help, draw a mesh from all sides "
      "into out/SCENE/preview.png; solve nothing");
  addSceneArguments(*command, *arguments);
  addExplainFlag(*command, arguments->explains);
  command->callback([&action, arguments] { action = [=] { return check(*arguments); }; });
}

}  // namespace morphgrid
