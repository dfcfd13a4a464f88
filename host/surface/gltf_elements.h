#pragma once
#include <string_view>

#include "surface/gltf_model.h"

namespace morphgrid {

/// Elements in a buffer, each of numbers of one type.
struct GltfElements {
  const char* begin;
  std::size_t stride;
  std::size_t count;

  /// Number `component` of an element; componentType is tinygltf's. Normalised, the greatest value
  /// of the type stands for 1, and the least for -1 where it has signs.
  double component(std::size_t element, int component, int componentType, bool isNormalized) const;
};

struct GltfLayout {
  std::size_t count;
  int componentType;
  int componentCount;
};

/// Elements that begin `byteOffset` bytes into a buffer view. Throws InputError, which begins with
/// the owner's name, when they do not fit into it, or it not into its buffer.
GltfElements locateElements(const GltfModel& model, std::string_view owner, int bufferView,
                            std::size_t byteOffset, const GltfLayout& layout);

}  // namespace morphgrid
