#pragma once
#include "app/scene.h"

namespace morphgrid {

/// Where a scene is read from, again and again with other overrides: its file, or the text that a
/// run's state holds.
struct SceneOrigin {
  std::filesystem::path file;       ///< What errors name; new files go beside it.
  std::string name;                 ///< See Scene.
  std::optional<std::string> text;  ///< Stands alone, see sceneText(); none: the file is the scene.
};

SceneOrigin sceneFile(const std::filesystem::path& file);

/// As loadScene() of a file.
Scene loadScene(const SceneOrigin& origin, const std::vector<std::string>& overrides);

/// The files that loadScene() reads: the scene's file, what it extends, its patch or mesh
/// configuration and the mesh. Throws InputError where they cannot be read as far as it takes to
/// know.
std::vector<std::filesystem::path> listSceneSources(const SceneOrigin& origin,
                                                    const std::vector<std::string>& overrides);

/// A scene file with the overrides in it, for a place beside the origin's file. Throws InputError
/// when the scene cannot be read.
std::string editedScene(const SceneOrigin& origin, const std::vector<std::string>& overrides);

}  // namespace morphgrid
