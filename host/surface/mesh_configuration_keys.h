#pragma once
#include "core/toml_key.h"
#include "surface/mesh_configuration.h"

namespace morphgrid {

/// All keys of mesh configurations: readMeshConfiguration() and docs/scene_format.md come from
/// here.
const std::vector<TomlKey<MeshConfiguration>>& meshConfigurationKeys();

}  // namespace morphgrid
