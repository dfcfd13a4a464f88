#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "gpu/device.h"

namespace morphgrid {

/// Solves a scene and leaves its state in the folder `out` beside it, as `morphgrid run` does;
/// returns the file. Without a device the scene's method must be "reference".
std::filesystem::path leaveState(const std::filesystem::path& scene,
                                 const std::vector<std::string>& overrides,
                                 std::shared_ptr<Device> device = nullptr);

}  // namespace morphgrid
