#pragma once
#include <tiny_gltf.h>

#include <vector>

#include "surface/mesh_source.h"

namespace morphgrid {

/// An accessor's vectors of three, x, y and z of each in turn: floats, or the integers of
/// KHR_mesh_quantization. Throws InputError when it is of another type, lies outside of its buffer
/// or holds what is not finite.
std::vector<double> readVectors(const MeshSource& source, const tinygltf::Model& model,
                                int accessor);

/// An accessor's unsigned integers. Throws alike, and when one is not below `vertexCount`.
std::vector<int> readIndices(const MeshSource& source, const tinygltf::Model& model, int accessor,
                             std::size_t vertexCount);

}  // namespace morphgrid
