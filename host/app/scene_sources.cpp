#include "app/scene_sources.h"

#include <algorithm>
#include <iterator>

#include "app/scene_keys.h"
#include "core/toml_reader.h"

namespace morphgrid {

std::vector<std::filesystem::path> listSceneSources(const std::filesystem::path& scene,
                                                    const std::vector<std::string>& overrides) {
  std::vector<std::filesystem::path> sources = listTomlFiles(scene, overrides);
  TomlReader reader(scene, parseToml(scene, overrides));
  forEachFileKey([&](const auto& section, const auto& name, const FileKey<Scene>& key) {
    const auto file = reader.section(section).path(name);
    if (!file) return;
    sources.push_back(*file);
    if (key.listNamed) {
      std::ranges::copy(key.listNamed(*file), std::back_inserter(sources));
    }
  });
  return sources;
}

}  // namespace morphgrid
