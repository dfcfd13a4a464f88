#include "app/state_argument.h"

#include <fmt/format.h>

#include "core/error.h"

namespace morphgrid {

void refuseFinishedRun(const std::filesystem::path& argument) {
  if (const auto state = findState(argument)) {
    throw InputError(fmt::format(
        "{}: is a finished run: see it with morphgrid view or figures; this command takes its "
        "scene: {}",
        argument.string(), readState(*state).sceneFile.string()));
  }
}

void refuseOverrides(const std::filesystem::path& argument, const std::filesystem::path& state,
                     const std::vector<std::string>& overrides) {
  if (!overrides.empty()) {
    throw InputError(
        fmt::format("{}: is a finished run, which --set cannot change; give its scene: {}",
                    argument.string(), readState(state).sceneFile.string()));
  }
}

}  // namespace morphgrid
