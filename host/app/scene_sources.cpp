#include "app/scene_sources.h"

#include "core/toml_reader.h"
#include "surface/mesh_configuration.h"

namespace morphgrid {

std::vector<std::filesystem::path> listSceneSources(const std::filesystem::path& scene,
                                                    const std::vector<std::string>& overrides) {
  std::vector<std::filesystem::path> sources = listTomlFiles(scene, overrides);
  TomlReader reader(scene, parseToml(scene, overrides));
  TomlSection surface = reader.section("surface");
  if (const auto patch = surface.path("patch")) {
    sources.push_back(*patch);
  }
  if (const auto mesh = surface.path("mesh")) {
    sources.push_back(*mesh);
    sources.push_back(readMeshConfiguration(*mesh).mesh);
  }
  return sources;
}

}  // namespace morphgrid
