#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "surface/gltf_json.h"

namespace morphgrid {

/// The bytes of a glTF file's buffers. A file that several of them name is read once.
class GltfBuffers {
 public:
  /// Throws InputError when a buffer has no bytes, or fewer than it says.
  GltfBuffers(const MeshSource& source, const GltfJson& gltf);

  /// Of each buffer, as many as it says; a GLB file's own lie in the source.
  const std::vector<std::string_view>& bytes() const { return bytes_; }

 private:
  std::string_view contentOf(const MeshSource& source, const nlohmann::json& buffer,
                             std::string_view binary);
  std::string_view contentOfUri(const MeshSource& source, const std::string& uri, int index);

  std::vector<std::string_view> bytes_;
  std::map<std::string, std::unique_ptr<const std::string>> contents_;  ///< By file or buffer.
};

}  // namespace morphgrid
