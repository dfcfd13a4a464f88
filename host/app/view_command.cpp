#include "app/command_end.h"
#include "app/command_options.h"
#include "app/commands.h"
#include "app/live_run.h"
#include "app/propose_files.h"
#include "core/on_interrupt.h"
#include "view/viewer.h"

namespace morphgrid {
namespace {

struct ViewArguments {
  SceneArguments scene;
  std::filesystem::path outputFolder;
  DeviceOptions device;
  std::optional<double> statisticsSeconds;
};

/// What is wrong with the scene or the state is told here rather than in a window.
LiveRunOptions optionsFor(const ViewArguments& arguments) {
  const auto state = findState(arguments.scene.scene);
  LiveRunOptions options{.overrides = arguments.scene.overrides,
                         .outputFolder = arguments.outputFolder,
                         .wake = Window::wake};
  if (state) {
    options.stored.emplace(*state);
  }
  options.scene = state ? options.stored->origin()
                        : sceneFile(sceneFor(arguments.scene.scene, arguments.outputFolder, false));
  const Scene scene = loadScene(options.scene, options.overrides);
  if (!state || !options.stored->isOf(options.overrides)) {
    options.targets.targetOf(scene);
  }
  if (options.outputFolder.empty()) {
    // The finished run's own files stay as they are.
    options.outputFolder =
        state ? state->parent_path() / "exported" : std::filesystem::path("out") / scene.name;
  }
  return options;
}

int view(const ViewArguments& arguments) {
  LiveRunOptions options = optionsFor(arguments);
  const std::string name = options.scene.name;
  Window window({.title = "morphgrid"});
  DeviceOptions device = arguments.device;
  device.presentation = Window::presentation();
  RunContext context;
  context.device = std::make_shared<Device>(device);
  sayWhenCompiling(*context.device);
  const OnInterrupt closing(InterruptAct::stop, "");
  {
    LiveRun session(context.device, std::move(options));
    runViewer(
        *context.device, window, session,
        {.pictureFile = name + "_view.png", .statisticsSeconds = arguments.statisticsSeconds});
  }
  context.requireSilence();
  return interruptRequested() ? kInterrupted : kConverged;
}

}  // namespace

void addViewCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<ViewArguments>();
  CLI::App* command = app.add_subcommand(
      "view",
      "watch a scene being designed and solved in a window, or open a finished run as it is, and "
      "turn its knobs; what a knob, --set or \"Start again\" changes of a finished run is designed "
      "and solved from the scene that its state holds");
  addSceneOrRunArguments(*command, arguments->scene);
  command->add_option("--out", arguments->outputFolder,
                      "folder of exported files [out/SCENE, or `exported` in the run's folder]");
  addDeviceOptions(*command, arguments->device);
  command
      ->add_option("--statistics", arguments->statisticsSeconds,
                   "turn the scene and solve it again and again for so many seconds, print how "
                   "smoothly that went, and close")
      ->type_name("SECONDS")
      ->check(within(aboveUpTo(0, 1e6)));
  command->callback([&action, arguments] { action = [=] { return view(*arguments); }; });
}

}  // namespace morphgrid
