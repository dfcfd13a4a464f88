#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

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

}  // namespace morphgrid
