#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "state/run_state.h"

namespace morphgrid {

/// For commands that take a scene: throws InputError that names it when the argument is a finished
/// run.
void refuseFinishedRun(const std::filesystem::path& argument);

/// Throws InputError when there are overrides: a finished run does not change. argument: as the
/// user gave it.
void refuseOverrides(const std::filesystem::path& argument, const std::filesystem::path& state,
                     const std::vector<std::string>& overrides);

}  // namespace morphgrid
