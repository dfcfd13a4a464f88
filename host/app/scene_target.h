#pragma once
#include <filesystem>
#include <memory>
#include <optional>

#include "app/scene.h"
#include "core/toml_reader.h"

namespace morphgrid {

/// What a scene asks for: [surface], [grid] and [design], whose keys depend on the kind of surface.
struct SceneTarget {
  std::shared_ptr<const Surface> surface;
  std::shared_ptr<const MeshTarget> mesh;
  std::optional<BendAngleRequest> bendAngles;
  DesignRequest design;
};

/// Patches and meshes are looked up from `folder`. Problems, those of their files too, go to the
/// reader; without problems exactly one of surface, mesh and bendAngles is set.
SceneTarget readSceneTarget(TomlReader& reader, const std::filesystem::path& folder);

}  // namespace morphgrid
