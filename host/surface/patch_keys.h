#pragma once
#include "core/toml_key.h"
#include "surface/bezier_patch.h"

namespace morphgrid {

/// All keys of patch files: readPatch() and docs/scene_format.md come from here.
const std::vector<TomlKey<BezierPatch::ControlPoints>>& patchKeys();

}  // namespace morphgrid
