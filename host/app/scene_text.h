#pragma once
#include <string>

#include "core/toml_reader.h"

namespace morphgrid {

/// A scene in one text that stands alone: overrides and what the file extends are in it, the paths
/// of its target are absolute. reader: of a scene without problems.
std::string sceneText(TomlReader& reader);

}  // namespace morphgrid
