#include "app/command_options.h"

namespace morphgrid {
namespace {

void addArguments(CLI::App& command, const char* scene, SceneArguments& arguments) {
  command.add_option("SCENE", arguments.scene, scene)->required();
  command
      .add_option("--set", arguments.overrides,
                  "override a key of the scene, e.g. --set grid.layers=4; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

}  // namespace

void addSceneArguments(CLI::App& command, SceneArguments& arguments) {
  addArguments(command,
               "scene file, see docs/scene_format.md; or a mesh, for which a scene is proposed",
               arguments);
}

void addSceneOrRunArguments(CLI::App& command, SceneArguments& arguments) {
  addArguments(
      command,
      "scene file, see docs/scene_format.md; or a mesh, for which a scene is proposed; or a "
      "finished run: its folder or its state.safetensors",
      arguments);
}

void addDeviceOptions(CLI::App& command, DeviceOptions& options) {
  command.add_option("--device", options.selection,
                     "Vulkan device, by index or part of its name [the first that will do]");
  command.add_flag("--validate", options.validation,
                   "run under the Vulkan validation layers; any message is a device failure");
}

void addHubOptions(CLI::App& command, PrintRequest& request) {
  command
      .add_option("--pin", request.pin,
                  "diameter of the pins through hubs and tubes, mm [1.75, filament]")
      ->check(CLI::Range(0.2, 20.0));
  command
      .add_option("--clearance", request.clearance, "by how much wider their holes are, mm [0.2]")
      ->check(CLI::Range(0.0, 5.0));
  command.add_option("--loops", request.loops, "rings of a hub beside each other [2]")
      ->check(CLI::Range(1, 10));
  command
      .add_option("--passes", request.passes,
                  "of a strut on top of each other [as the material has it]")
      ->check(CLI::Range(1, 1000));
}

void addQuietFlag(CLI::App& command, bool& isQuiet) {
  command.add_flag("--quiet", isQuiet, "print errors only");
}

}  // namespace morphgrid
