#pragma once
#include <filesystem>
#include <string>

#include "core/toml_document.h"

namespace morphgrid {

/// A scene in one text that stands alone: overrides and what the file extends are in it, the paths
/// of its target are absolute. document: as parseToml() gives it.
std::string sceneText(const std::filesystem::path& file, const toml::table& document);

}  // namespace morphgrid
