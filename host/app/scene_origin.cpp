#include "app/scene_origin.h"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "app/scene_keys.h"
#include "core/toml_reader.h"

namespace morphgrid {

SceneOrigin sceneFile(const std::filesystem::path& file) {
  return {file, file.stem().string(), std::nullopt};
}

Scene loadScene(const SceneOrigin& origin, const std::vector<std::string>& overrides) {
  return origin.text ? loadSceneText(*origin.text, origin.file, origin.name, overrides)
                     : loadScene(origin.file, overrides);
}

std::vector<std::filesystem::path> listSceneSources(const SceneOrigin& origin,
                                                    const std::vector<std::string>& overrides) {
  const std::filesystem::path& file = origin.file;
  std::vector<std::filesystem::path> sources =
      origin.text ? std::vector{file} : listTomlFiles(file, overrides);
  TomlReader reader(file, origin.text ? parseTomlText(*origin.text, file, overrides)
                                      : parseToml(file, overrides));
  forEachFileKey([&](const auto& section, const auto& name, const FileKey<Scene>& key) {
    const auto named = reader.section(section).path(name);
    if (!named) return;
    sources.push_back(*named);
    if (key.listNamed) {
      std::ranges::copy(key.listNamed(*named), std::back_inserter(sources));
    }
  });
  return sources;
}

std::string editedScene(const SceneOrigin& origin, const std::vector<std::string>& overrides) {
  std::ostringstream text;
  text << (origin.text ? parseTomlText(*origin.text, origin.file, overrides)
                       : parseTomlAlone(origin.file, overrides))
       << '\n';
  return text.str();
}

}  // namespace morphgrid
