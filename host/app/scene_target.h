#pragma once
#include "app/scene.h"
#include "core/toml_reader.h"

namespace morphgrid {

/// What a scene asks for: [surface], [grid] and [design], whose keys depend on the kind of surface.
struct SceneTarget {
  SurfaceRequest surface;
  DesignRequest design;
};

/// Problems, those of patch files and mesh configurations too, go to the reader.
SceneTarget readSceneTarget(TomlReader& reader);

}  // namespace morphgrid
