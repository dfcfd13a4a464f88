#include "surface/gltf_model.h"

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

}  // namespace

/// tinygltf copies buffers for each that names them, wants data URIs in seven forms alone and files
/// of exactly the length that is due: it gets none. Nor does it get a GLB file's chunks, for it
/// reads up to eight bytes too far where the last is cut.
GltfModel readGltfModel(const MeshSource& source) {
  GltfJson gltf = parseGltf(source);
  GltfBuffers buffers(source, gltf);
  gltf.json.erase("buffers");
  nameMissingBindMatrices(gltf.json);
  const std::string text = gltf.json.dump();

  tinygltf::TinyGLTF loader;
  tinygltf::Model items;
  std::string error, warning;
  const bool isRead = loader.LoadASCIIFromString(&items, &error, &warning, text.data(),
                                                 static_cast<unsigned int>(text.size()), "");
  if (!isRead || !error.empty()) throw source.error(oneLine(error));
  return {source, std::move(items), std::move(buffers)};
}

}  // namespace morphgrid
