#pragma once
#include <cstdlib>
#include <filesystem>
#include <optional>

namespace morphgrid {

/// The folder of meshes that cannot be part of the project, when there is one: what the environment
/// variable MORPHGRID_SHARED names, or `shared` beside the checkout.
inline std::optional<std::filesystem::path> sharedFolder() {
  const char* const named = std::getenv("MORPHGRID_SHARED");
  const std::filesystem::path folder =
      named ? std::filesystem::path(named)
            : std::filesystem::path(MORPHGRID_SOURCE_DIR) / "../shared";
  if (!std::filesystem::exists(folder / "meshes")) return std::nullopt;
  return folder;
}

}  // namespace morphgrid
