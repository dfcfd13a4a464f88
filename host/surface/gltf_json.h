#pragma once
#include <nlohmann/json.hpp>

#include "surface/mesh_source.h"

namespace morphgrid {

/// A glTF file's own bytes, taken apart.
struct GltfJson {
  nlohmann::json json;      ///< An object, of what places triangles alone.
  std::string_view binary;  ///< A GLB file's binary chunk, where it has one.
};

/// Parses a glTF or GLB file: no images, materials or animations, and of extensions only the
/// visibility of nodes. Throws InputError when it is no glTF 2, or requires an extension that
/// geometry depends on and that is not known here.
GltfJson parseGltf(const MeshSource& source);

}  // namespace morphgrid
