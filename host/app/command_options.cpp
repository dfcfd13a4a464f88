#include "app/command_options.h"

#include <fmt/format.h>

#include <charconv>

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

CLI::Validator within(const NumberRange& range) {
  const auto check = [range](std::string& text) -> std::string {
    double number = 0;
    if (CLI::detail::lexical_cast(text, number) && range.contains(number)) return "";
    return fmt::format("must be {}, got {}", describe(range), text);
  };
  return {check, ""};
}

CLI::Validator wholeNumber() {
  const auto check = [](std::string& text) -> std::string {
    std::uint64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    if (read.ec == std::errc() && read.ptr == end) return "";
    return fmt::format("must be an integer >= 0 and < 2^64, got {}", text);
  };
  return {check, ""};
}

void addDeviceOptions(CLI::App& command, DeviceOptions& options) {
  command.add_option("--device", options.selection,
                     "Vulkan device, by index or part of its name [the first that will do]");
  command.add_flag("--validate", options.validation,
                   "run under the Vulkan validation layers; any message is a device failure");
}

void addExplainFlag(CLI::App& command, bool& explains) {
  command.add_flag("--explain", explains, "say what the rows of the table mean");
}

void addQuietFlag(CLI::App& command, bool& isQuiet) {
  command.add_flag("--quiet", isQuiet, "print errors only");
}

}  // namespace morphgrid
