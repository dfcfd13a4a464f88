#pragma once
#include <fmt/format.h>
#include <tiny_gltf.h>

#include <vector>

#include "surface/gltf_buffers.h"

namespace morphgrid {

/// A glTF or GLB file, of its JSON only what places triangles, and its buffers. Indices and ranges
/// are as in the file, unchecked. It refers to its source.
struct GltfModel {
  const MeshSource& source;
  tinygltf::Model items;  ///< Without buffers.
  GltfBuffers buffers;
};

/// Throws InputError.
GltfModel readGltfModel(const MeshSource& source);

/// An item of a model by its index. Throws InputError when there is none.
template <typename Item>
const Item& itemAt(const MeshSource& source, const std::vector<Item>& items, int index,
                   const char* name) {
  if (index >= 0 && index < static_cast<int>(items.size())) return items[index];
  throw source.error(fmt::format("{} {} does not exist, there are {} (counted from 0)", name, index,
                                 items.size()));
}

}  // namespace morphgrid
