#include "app/scene_origin.h"

#include <sstream>

#include "core/toml_reader.h"
#include "surface/mesh_configuration.h"

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

std::string editedScene(const SceneOrigin& origin, const std::vector<std::string>& overrides) {
  std::ostringstream text;
  text << (origin.text ? parseTomlText(*origin.text, origin.file, overrides)
                       : parseTomlAlone(origin.file, overrides))
       << '\n';
  return text.str();
}

}  // namespace morphgrid
