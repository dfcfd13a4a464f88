#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "core/number_range.h"
#include "gpu/device.h"

namespace morphgrid {

/// What a command works on, as the user gives it.
struct SceneArguments {
  std::filesystem::path scene;  ///< For some commands a finished run, too.
  std::vector<std::string> overrides;
};

/// SCENE and --set.
void addSceneArguments(CLI::App& command, SceneArguments& arguments);
/// The same for a command that takes a finished run too.
void addSceneOrRunArguments(CLI::App& command, SceneArguments& arguments);
/// --device and --validate.
void addDeviceOptions(CLI::App& command, DeviceOptions& options);
/// --quiet.
void addExplainFlag(CLI::App& command, bool& explains);
void addQuietFlag(CLI::App& command, bool& isQuiet);

/// Takes numbers of a range alone; says what it is in few words.
CLI::Validator within(const NumberRange& range);
/// Takes whole numbers from 0 on alone: CLI11 would take -1 for the largest there is.
CLI::Validator wholeNumber();

/// --pin, --clearance, --loops and --passes, into members of these names.
template <typename Keys>
void addHubOptions(CLI::App& command, Keys& keys) {
  command
      .add_option("--pin", keys.pin,
                  "diameter of the pins through hubs and tubes, mm [1.75, filament]")
      ->check(within(fromTo(0.2, 20)));
  command.add_option("--clearance", keys.clearance, "by how much wider their holes are, mm [0.2]")
      ->check(within(fromTo(0, 5)));
  command.add_option("--loops", keys.loops, "rings of a hub beside each other [2]")
      ->check(CLI::Range(1, 10));
  command
      .add_option("--passes", keys.passes,
                  "of a strut on top of each other [as the material has it]")
      ->check(CLI::Range(1, 1000));
}

}  // namespace morphgrid
