#include "surface/gltf_buffers.h"

#include <fmt/format.h>

#include <system_error>

#include "surface/data_uri.h"

namespace morphgrid {
namespace {

using nlohmann::json;

const std::size_t kLongestFileName = 1024;

InputError bufferError(const MeshSource& source, int index, std::string_view what) {
  return source.error(fmt::format("buffer {}: {}", index, what));
}

/// Whether a URI begins like `http:`; a single letter is a drive of Windows.
bool hasScheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  return colon != std::string_view::npos && colon > 1 && uri.find('/') > colon;
}

/// A mesh may come from anybody: it may not tell what else is on the disk. Links are followed; what
/// cannot be resolved cannot be read either.
bool isBeside(const std::filesystem::path& file, const std::filesystem::path& mesh) {
  std::error_code ignored;
  const auto folder = std::filesystem::weakly_canonical(std::filesystem::absolute(mesh), ignored);
  const auto within = std::filesystem::weakly_canonical(std::filesystem::absolute(file), ignored)
                          .lexically_relative(folder.parent_path());
  return !within.empty() && *within.begin() != "..";
}

}  // namespace

GltfBuffers::GltfBuffers(const MeshSource& source, const GltfJson& gltf) {
  const auto buffers = gltf.json.find("buffers");
  if (buffers == gltf.json.end()) return;
  if (!buffers->is_array()) throw source.error("buffers must be an array");
  for (const json& buffer : *buffers) {
    const int index = static_cast<int>(bytes_.size());
    if (!buffer.is_object()) throw bufferError(source, index, "must be an object");
    const auto length = buffer.find("byteLength");
    if (length == buffer.end() || !length->is_number_unsigned()) {
      throw bufferError(source, index, "byteLength must be an integer >= 0");
    }
    const auto size = length->get<std::size_t>();
    const std::string_view content = contentOf(source, buffer, index == 0 ? gltf.binary : "");
    if (content.size() < size) {
      throw bufferError(
          source, index,
          fmt::format("says that it has {} bytes, there are {}", size, content.size()));
    }
    bytes_.push_back(content.substr(0, size));
  }
}

std::string_view GltfBuffers::contentOf(const MeshSource& source, const json& buffer,
                                        std::string_view binary) {
  const int index = static_cast<int>(bytes_.size());
  const auto uri = buffer.find("uri");
  if (uri != buffer.end() && uri->is_string()) {
    return contentOfUri(source, uri->get_ref<const std::string&>(), index);
  }
  if (!binary.empty()) return binary;
  throw bufferError(source, index, "has no URI, and is no binary chunk of a GLB file");
}

std::string_view GltfBuffers::contentOfUri(const MeshSource& source, const std::string& uri,
                                           int index) {
  if (isDataUri(uri)) {
    auto content = decodeDataUri(uri);
    if (!content) throw bufferError(source, index, "its data URI is malformed: " + inQuotes(uri));
    auto& kept = contents_[fmt::format("data:{}", index)];
    kept = std::make_unique<const std::string>(std::move(*content));
    return *kept;
  }
  if (hasScheme(uri) || uri.size() > kLongestFileName) {
    throw bufferError(source, index, "its URI is no file's: " + inQuotes(uri));
  }
  const std::filesystem::path file = source.file.parent_path() / decodePercent(uri);
  if (!isBeside(file, source.file)) {
    throw bufferError(
        source, index,
        "its file must lie in the folder of the glTF file or below, got " + inQuotes(uri));
  }
  std::error_code ignored;
  auto& kept = contents_[std::filesystem::weakly_canonical(file, ignored).string()];
  if (!kept) kept = std::make_unique<const std::string>(readMeshFile(file));
  return *kept;
}

}  // namespace morphgrid
