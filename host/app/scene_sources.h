#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace morphgrid {

/// The files that loadScene() reads: the scene, what it extends, its patch or mesh configuration
/// and the mesh. Throws InputError where they cannot be read as far as it takes to know.
std::vector<std::filesystem::path> listSceneSources(const std::filesystem::path& scene,
                                                    const std::vector<std::string>& overrides);

}  // namespace morphgrid
