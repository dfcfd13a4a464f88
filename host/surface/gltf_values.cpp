#include "surface/gltf_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "surface/gltf_elements.h"

namespace morphgrid {
namespace {

/// Nodes may show a mesh again and again: so many values for each byte of the file.
const std::size_t kMostValuesPerByte = 100;

/// An accessor's own error; -> "accessor 3: what".
InputError accessorError(const MeshSource& source, int accessor, std::string_view what) {
  return source.error(fmt::format("accessor {}: {}", accessor, what));
}

void requireKind(const GltfModel& model, int index, const GltfKind& kind) {
  const auto& accessor = itemAt(model.source, model.items.accessors, index, "accessor");
  if (accessor.type == kind.type &&
      std::ranges::find(kind.componentTypes, accessor.componentType) != kind.componentTypes.end()) {
    return;
  }
  throw accessorError(model.source, index, kind.wanted);
}

}  // namespace

const GltfKind kGltfPositions = {
    TINYGLTF_TYPE_VEC3,
    {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE,
     TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_SHORT,
     TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT},
    "positions must be VEC3 of floats, bytes or shorts"};

const GltfKind kGltfIndices = {
    TINYGLTF_TYPE_SCALAR,
    {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
     TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT},
    "indices must be SCALAR, unsigned bytes, shorts or ints"};

const GltfKind kGltfJoints = {
    TINYGLTF_TYPE_VEC4,
    {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT},
    "joints must be VEC4 of unsigned bytes or shorts"};

const GltfKind kGltfWeights = {
    TINYGLTF_TYPE_VEC4,
    {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
     TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT},
    "weights must be VEC4 of floats, unsigned bytes or shorts"};

const GltfKind kGltfMatrices = {TINYGLTF_TYPE_MAT4,
                                {TINYGLTF_COMPONENT_TYPE_FLOAT},
                                "inverse bind matrices must be MAT4 of floats"};

GltfValues::GltfValues(const GltfModel& model) : model_(model) {
  for (const std::string_view buffer : model.buffers.bytes()) valuesLeft_ += buffer.size();
  valuesLeft_ =
      std::min(kMostValuesPerByte * (valuesLeft_ + model.source.bytes.size()), kMostMeshBytes);
}

std::vector<double> GltfValues::read(int index, const GltfKind& kind) {
  requireKind(model_, index, kind);
  const tinygltf::Accessor& accessor = model_.items.accessors[index];
  const int componentCount = tinygltf::GetNumComponentsInType(accessor.type);
  const std::string owner = fmt::format("accessor {}", index);
  GltfElements elements{nullptr, 0, 0};
  if (accessor.bufferView >= 0) {
    elements = locateElements(model_, owner, accessor.bufferView, accessor.byteOffset,
                              {accessor.count, accessor.componentType, componentCount});
  }
  requireRoom(accessor.count > kMostMeshBytes ? kMostMeshBytes : accessor.count * componentCount);
  std::vector<double> values(accessor.count * componentCount);
  for (std::size_t i = 0; i < elements.count * componentCount; ++i) {
    values[i] = elements.component(i / componentCount, static_cast<int>(i % componentCount),
                                   accessor.componentType, accessor.normalized);
  }
  if (accessor.sparse.isSparse) placeSparse(index, componentCount, values);
  const auto bad = std::ranges::find_if(values, [](double value) { return !std::isfinite(value); });
  if (bad != values.end()) {
    throw accessorError(model_.source, index,
                        fmt::format("element {}: numbers must be finite, got {}",
                                    (bad - values.begin()) / componentCount, *bad));
  }
  return values;
}

void GltfValues::placeSparse(int index, int componentCount, std::vector<double>& values) const {
  const tinygltf::Accessor& accessor = model_.items.accessors[index];
  const auto& [count, isSparse, places, replaced] = accessor.sparse;
  const std::string owner = fmt::format("accessor {}, sparse", index);
  if (count < 0 || places.byteOffset < 0 || replaced.byteOffset < 0) {
    throw model_.source.error(owner + ": count and byte offsets must be >= 0");
  }
  const auto size = static_cast<std::size_t>(count);
  if (std::ranges::find(kGltfIndices.componentTypes, places.componentType) ==
      kGltfIndices.componentTypes.end()) {
    throw model_.source.error(fmt::format("{}: {}", owner, kGltfIndices.wanted));
  }
  const GltfElements from = locateElements(model_, owner, places.bufferView, places.byteOffset,
                                           {size, places.componentType, 1});
  const GltfElements to = locateElements(model_, owner, replaced.bufferView, replaced.byteOffset,
                                         {size, accessor.componentType, componentCount});
  for (std::size_t i = 0; i < size; ++i) {
    const double place = from.component(i, 0, places.componentType, false);
    if (place >= static_cast<double>(accessor.count)) {
      throw model_.source.error(
          fmt::format("{}: element {} does not exist, there are {}", owner, place, accessor.count));
    }
    for (int j = 0; j < componentCount; ++j) {
      values[static_cast<std::size_t>(place) * componentCount + j] =
          to.component(i, j, accessor.componentType, accessor.normalized);
    }
  }
}

std::vector<int> GltfValues::readIndices(int index, std::size_t vertexCount) {
  const std::vector<double> values = read(index, kGltfIndices);
  const auto bad = std::ranges::find_if(
      values, [&](double value) { return value >= static_cast<double>(vertexCount); });
  if (bad != values.end()) {
    throw accessorError(
        model_.source, index,
        fmt::format("element {}: vertex {} does not exist, there are 0 to {}", bad - values.begin(),
                    *bad, static_cast<double>(vertexCount) - 1));
  }
  return {values.begin(), values.end()};
}

std::size_t GltfValues::countOf(int index) const {
  return itemAt(model_.source, model_.items.accessors, index, "accessor").count;
}

void GltfValues::requireRoom(std::size_t count) {
  if (count > valuesLeft_) {
    throw model_.source.error(
        "has more values read, or its meshes repeated more often, than can be held in memory");
  }
  valuesLeft_ -= count;
}

}  // namespace morphgrid
