#pragma once
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "tests/support/folders.h"

namespace morphgrid {

/// The folder of meshes that cannot be part of the project, when there is one: what the environment
/// variable MORPHGRID_SHARED names, or `shared` beside the checkout.
inline std::optional<std::filesystem::path> sharedFolder() {
  const char* const named = std::getenv("MORPHGRID_SHARED");
  const std::filesystem::path folder =
      named ? std::filesystem::path(named) : sourceFolder() / "../shared";
  if (!std::filesystem::exists(folder / "meshes")) return std::nullopt;
  return folder;
}

}  // namespace morphgrid
