#pragma once
#include <fmt/format.h>
#include <tiny_gltf.h>

#include <vector>

#include "surface/mesh_source.h"

namespace morphgrid {

/// Reads a glTF or GLB file with its buffers, and of its JSON only what places triangles:
/// no images, materials, animations, extensions. Indices and ranges are as in the file, unchecked.
/// Throws InputError.
tinygltf::Model readGltfModel(const MeshSource& source);

/// An item of the model by its index. Throws InputError when there is none.
template <typename Item>
const Item& itemAt(const MeshSource& source, const std::vector<Item>& items, int index,
                   const char* name) {
  if (index >= 0 && index < static_cast<int>(items.size())) return items[index];
  throw source.error(fmt::format("{} {} does not exist, there are {} (counted from 0)", name, index,
                                 items.size()));
}

}  // namespace morphgrid
