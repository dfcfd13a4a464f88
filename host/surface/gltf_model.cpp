#include "surface/gltf_model.h"

#include <vector>

namespace morphgrid {
namespace {

/// tinygltf takes those for required; the specification has identities stand for them.
void nameMissingBindMatrices(nlohmann::json& gltf) {
  const auto skins = gltf.find("skins");
  if (skins == gltf.end() || !skins->is_array()) return;
  for (nlohmann::json& skin : *skins) {
    if (skin.is_object()) skin.emplace("inverseBindMatrices", -1);
  }
}

/// tinygltf refuses indices without a buffer view: accessors without one name one more until it is
/// done. These accessors.
std::vector<std::size_t> nameMissingBufferViews(nlohmann::json& gltf) {
  auto& views = gltf["bufferViews"];
  auto& accessors = gltf["accessors"];
  if (views.is_null()) views = nlohmann::json::array();
  if (!views.is_array() || !accessors.is_array()) return {};
  std::vector<std::size_t> named;
  for (std::size_t i = 0; i < accessors.size(); ++i) {
    if (!accessors[i].is_object()) continue;
    if (accessors[i].emplace("bufferView", views.size()).second) named.push_back(i);
  }
  if (!named.empty()) views.push_back({{"buffer", 0}, {"byteLength", 1}});
  return named;
}

void dropNamedBufferView(tinygltf::Model& items, const std::vector<std::size_t>& named) {
  if (named.empty()) return;
  items.bufferViews.pop_back();
  for (const std::size_t accessor : named) items.accessors[accessor].bufferView = -1;
}

}  // namespace

/// tinygltf copies buffers for each that names them, wants data URIs in seven forms alone and files
/// of exactly the length that is due: it gets none. Nor does it get a GLB file's chunks, for it
/// reads up to eight bytes too far where the last is cut.
GltfModel readGltfModel(const MeshSource& source) {
  GltfJson gltf = parseGltf(source);
  GltfBuffers buffers(source, gltf);
  gltf.json.erase("buffers");
  nameMissingBindMatrices(gltf.json);
  const std::vector<std::size_t> named = nameMissingBufferViews(gltf.json);
  const std::string text = gltf.json.dump();

  tinygltf::TinyGLTF loader;
  tinygltf::Model items;
  std::string error, warning;
  const bool isRead = loader.LoadASCIIFromString(&items, &error, &warning, text.data(),
                                                 static_cast<unsigned int>(text.size()), "");
  if (!isRead || !error.empty()) throw source.error(oneLine(error));
  dropNamedBufferView(items, named);
  return {source, std::move(items), std::move(buffers)};
}

}  // namespace morphgrid
