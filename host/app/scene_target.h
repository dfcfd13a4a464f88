#pragma once
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

/// Problems, those of patches' and meshes' files too, go to the reader; without problems exactly
/// one of surface, mesh and bendAngles is set.
SceneTarget readSceneTarget(TomlReader& reader);

}  // namespace morphgrid
