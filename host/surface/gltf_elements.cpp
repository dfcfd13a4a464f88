#include "surface/gltf_elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

namespace morphgrid {
namespace {

template <typename Value>
Value valueAt(const char* bytes) {
  Value value;
  std::memcpy(&value, bytes, sizeof(value));
  return value;
}

template <typename Value>
double integerAt(const char* bytes, bool isNormalized) {
  const double value = valueAt<Value>(bytes);
  return isNormalized ? std::max(value / std::numeric_limits<Value>::max(), -1.0) : value;
}

double componentAt(const char* bytes, int componentType, bool isNormalized) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return integerAt<std::int8_t>(bytes, isNormalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return integerAt<std::uint8_t>(bytes, isNormalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return integerAt<std::int16_t>(bytes, isNormalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return integerAt<std::uint16_t>(bytes, isNormalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return integerAt<std::uint32_t>(bytes, isNormalized);
    default:
      return valueAt<float>(bytes);
  }
}

}  // namespace

double GltfElements::component(std::size_t element, int component, int componentType,
                               bool isNormalized) const {
  const int size = tinygltf::GetComponentSizeInBytes(componentType);
  return componentAt(begin + stride * element + size * component, componentType, isNormalized);
}

/// The sizes come from the file, up to 2^64: sums could wrap around.
GltfElements locateElements(const GltfModel& model, std::string_view owner, int bufferView,
                            std::size_t byteOffset, const GltfLayout& layout) {
  const MeshSource& source = model.source;
  const auto& view = itemAt(source, model.items.bufferViews, bufferView, "buffer view");
  const std::string_view bytes = itemAt(source, model.buffers.bytes(), view.buffer, "buffer");
  if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset) {
    throw source.error(fmt::format("buffer view {}: {} bytes from byte {} on, the buffer has {}",
                                   bufferView, view.byteLength, view.byteOffset, bytes.size()));
  }
  const std::size_t elementBytes =
      tinygltf::GetComponentSizeInBytes(layout.componentType) * layout.componentCount;
  const std::size_t stride = view.byteStride > 0 ? view.byteStride : elementBytes;
  const std::size_t left = view.byteLength - std::min(byteOffset, view.byteLength);
  const std::size_t most = left < elementBytes ? 0 : (left - elementBytes) / stride + 1;
  if (layout.count > most) {
    throw source.error(fmt::format("{}: {} elements, its buffer view holds {} from byte {} on",
                                   owner, layout.count, most, byteOffset));
  }
  return {bytes.data() + view.byteOffset + (most > 0 ? byteOffset : 0), stride, layout.count};
}

}  // namespace morphgrid
