#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "surface/triangle_mesh.h"

namespace morphgrid {

/// tinygltf's and OpenGL's numbers of types.
inline constexpr int kFloat = 5126;
inline constexpr int kUnsignedByte = 5121;
inline constexpr int kUnsignedShort = 5123;

/// Four corners of a unit square, and the indices of its two triangles.
std::string squareBytes();

/// The JSON of the square, shown by one node: accessor 0 holds its corners, 1 its indices.
nlohmann::json square();

/// Adds an accessor of bytes that are appended to the binary chunk; its index.
int addAccessor(nlohmann::json& gltf, std::string& chunk, const std::string& bytes,
                const std::string& type, int componentType, int count);

/// As a GLB file.
std::string glb(const nlohmann::json& gltf, const std::string& bytes = squareBytes());

TriangleMesh meshOfGltf(const nlohmann::json& gltf, const std::string& bytes = squareBytes());

std::string problemOfGltf(const nlohmann::json& gltf, const std::string& bytes = squareBytes());

}  // namespace morphgrid
