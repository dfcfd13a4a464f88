#include "tests/surface/gltf_squares.h"

#include <cstdint>

#include "tests/surface/mesh_files.h"

namespace morphgrid {
namespace {

using nlohmann::json;

std::string chunk(const std::string& type, std::string content) {
  content.resize((content.size() + 3) / 4 * 4, type == "JSON" ? ' ' : '\0');
  return bytesOf(static_cast<std::uint32_t>(content.size())) + type + content;
}

}  // namespace

std::string squareBytes() {
  return bytesOf(0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 1.f, 1.f, 0.f) +
         bytesOf<std::uint16_t, std::uint16_t, std::uint16_t>(0, 1, 2) +
         bytesOf<std::uint16_t, std::uint16_t, std::uint16_t>(2, 1, 3);
}

json square() {
  json gltf = json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [{"bufferView": 0, "count": 4, "type": "VEC3"},
                  {"bufferView": 1, "count": 6, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48},
                    {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
    "buffers": [{"byteLength": 60}]})");
  gltf["accessors"][0]["componentType"] = kFloat;
  gltf["accessors"][1]["componentType"] = kUnsignedShort;
  return gltf;
}

int addAccessor(json& gltf, std::string& bytes, const std::string& added, const std::string& type,
                int componentType, int count) {
  gltf["accessors"].push_back({{"bufferView", gltf["bufferViews"].size()},
                               {"componentType", componentType},
                               {"count", count},
                               {"type", type}});
  gltf["bufferViews"].push_back(
      {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", added.size()}});
  bytes += added;
  bytes.resize((bytes.size() + 3) / 4 * 4);
  gltf["buffers"][0]["byteLength"] = bytes.size();
  return static_cast<int>(gltf["accessors"].size()) - 1;
}

std::string glb(const json& gltf, const std::string& bytes) {
  std::string chunks = chunk("JSON", gltf.dump());
  if (!bytes.empty()) chunks += chunk(std::string("BIN\0", 4), bytes);
  return "glTF" + bytesOf(std::uint32_t{2}, static_cast<std::uint32_t>(12 + chunks.size())) +
         chunks;
}

TriangleMesh meshOfGltf(const json& gltf, const std::string& bytes) {
  return meshOf("a.glb", glb(gltf, bytes));
}

std::string problemOfGltf(const json& gltf, const std::string& bytes) {
  return problemOf("a.glb", glb(gltf, bytes));
}

}  // namespace morphgrid
