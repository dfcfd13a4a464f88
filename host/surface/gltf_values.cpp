#include "surface/gltf_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>

#include "surface/gltf_model.h"

namespace morphgrid {
namespace {

InputError accessorError(const MeshSource& source, int accessor, std::string_view what) {
  return source.error(fmt::format("accessor {}: {}", accessor, what));
}

/// Where an accessor's elements are.
struct Elements {
  const unsigned char* begin;
  std::size_t stride;
  std::size_t count;
};

/// The sizes come from the file, up to 2^64: sums could wrap around.
Elements locate(const MeshSource& source, const tinygltf::Model& model, int index) {
  const tinygltf::Accessor& accessor = model.accessors[index];
  if (accessor.sparse.isSparse || accessor.bufferView < 0) {
    throw accessorError(source, index, "sparse ones and ones without a buffer view cannot be read");
  }
  const auto& view = itemAt(source, model.bufferViews, accessor.bufferView, "buffer view");
  const auto& bytes = itemAt(source, model.buffers, view.buffer, "buffer").data;
  if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset) {
    throw source.error(fmt::format("buffer view {}: {} bytes from byte {} on, the buffer has {}",
                                   accessor.bufferView, view.byteLength, view.byteOffset,
                                   bytes.size()));
  }
  const std::size_t elementBytes = tinygltf::GetComponentSizeInBytes(accessor.componentType) *
                                   tinygltf::GetNumComponentsInType(accessor.type);
  const std::size_t stride = view.byteStride > 0 ? view.byteStride : elementBytes;
  const std::size_t left = view.byteLength - std::min(accessor.byteOffset, view.byteLength);
  const std::size_t most = left < elementBytes ? 0 : (left - elementBytes) / stride + 1;
  if (accessor.count > most) {
    throw accessorError(source, index,
                        fmt::format("{} elements, its buffer view holds {} from byte {} on",
                                    accessor.count, most, accessor.byteOffset));
  }
  return {bytes.data() + view.byteOffset + (most > 0 ? accessor.byteOffset : 0), stride,
          accessor.count};
}

void requireType(const MeshSource& source, const tinygltf::Model& model, int index, int type,
                 std::initializer_list<int> componentTypes, std::string_view wanted) {
  const auto& accessor = itemAt(source, model.accessors, index, "accessor");
  if (accessor.type == type &&
      std::ranges::find(componentTypes, accessor.componentType) != componentTypes.end()) {
    return;
  }
  throw accessorError(source, index, wanted);
}

template <typename Value>
Value valueAt(const unsigned char* bytes) {
  Value value;
  std::memcpy(&value, bytes, sizeof(value));
  return value;
}

/// Normalised, the greatest value of the type stands for 1, and the least for -1 where it has
/// signs.
template <typename Value>
double integerAt(const unsigned char* bytes, bool isNormalized) {
  const double value = valueAt<Value>(bytes);
  return isNormalized ? std::max(value / std::numeric_limits<Value>::max(), -1.0) : value;
}

double componentAt(const unsigned char* bytes, int componentType, bool isNormalized) {
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

std::vector<double> readVectors(const MeshSource& source, const tinygltf::Model& model, int index) {
  requireType(source, model, index, TINYGLTF_TYPE_VEC3,
              {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE,
               TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_SHORT,
               TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT},
              "positions must be VEC3 of floats, bytes or shorts");
  const tinygltf::Accessor& accessor = model.accessors[index];
  const Elements elements = locate(source, model, index);
  const int size = tinygltf::GetComponentSizeInBytes(accessor.componentType);
  std::vector<double> coordinates;
  coordinates.reserve(3 * elements.count);
  for (std::size_t i = 0; i < elements.count; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double value = componentAt(elements.begin + elements.stride * i + size * j,
                                       accessor.componentType, accessor.normalized);
      if (!std::isfinite(value)) {
        throw accessorError(
            source, index, fmt::format("element {}: coordinates must be finite, got {}", i, value));
      }
      coordinates.push_back(value);
    }
  }
  return coordinates;
}

std::vector<int> readIndices(const MeshSource& source, const tinygltf::Model& model, int index,
                             std::size_t vertexCount) {
  requireType(source, model, index, TINYGLTF_TYPE_SCALAR,
              {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
               TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT},
              "indices must be SCALAR, unsigned bytes, shorts or ints");
  const Elements elements = locate(source, model, index);
  std::vector<int> indices;
  indices.reserve(elements.count);
  for (std::size_t i = 0; i < elements.count; ++i) {
    const double value = componentAt(elements.begin + elements.stride * i,
                                     model.accessors[index].componentType, false);
    if (value >= static_cast<double>(vertexCount)) {
      throw accessorError(source, index,
                          fmt::format("element {}: vertex {} does not exist, there are 0 to {}", i,
                                      value, static_cast<double>(vertexCount) - 1));
    }
    indices.push_back(static_cast<int>(value));
  }
  return indices;
}

}  // namespace morphgrid
