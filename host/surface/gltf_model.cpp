#include "surface/gltf_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

namespace morphgrid {
namespace {

using nlohmann::json;

const int kDeepestNesting = 32;  ///< glTF itself needs 6; tinygltf recurses.

const std::string_view kNeededSections[] = {"asset",       "scene",   "scenes",
                                            "nodes",       "meshes",  "accessors",
                                            "bufferViews", "buffers", "extensionsRequired"};

/// The URI that stands for a GLB file's binary chunk.
const char* const kBinaryChunk = "binary chunk";

struct Chunks {
  std::string_view json;
  std::string_view binary;
};

std::uint32_t wordAt(const MeshSource& source, std::size_t offset) {
  std::uint32_t word = 0;
  if (offset + sizeof(word) > source.bytes.size()) {
    throw source.errorAtByte(source.bytes.size(), "the file ends within a header");
  }
  std::memcpy(&word, source.bytes.data() + offset, sizeof(word));
  return word;
}

/// The chunk at `offset`: its length and type, of four bytes each, then its content.
std::string_view chunkAt(const MeshSource& source, std::size_t offset, std::string_view type) {
  const std::size_t length = wordAt(source, offset);
  const std::size_t begin = offset + 8;
  wordAt(source, offset + 4);
  if (source.bytes.substr(offset + 4, 4) != type) {
    throw source.errorAtByte(offset + 4,
                             fmt::format("a chunk of type {} expected", inQuotes(type)));
  }
  if (length > source.bytes.size() - begin) {
    throw source.errorAtByte(offset, fmt::format("a chunk of {} bytes, the file has {} more",
                                                 length, source.bytes.size() - begin));
  }
  return source.bytes.substr(begin, length);
}

/// tinygltf reads up to eight bytes too far in a GLB file whose last chunk is cut, and copies the
/// binary chunk for every buffer without a URI: it gets the chunks one by one.
Chunks splitChunks(const MeshSource& source) {
  if (!source.bytes.starts_with("glTF")) return {source.bytes, {}};
  if (wordAt(source, 4) != 2) throw source.errorAtByte(4, "only version 2 of GLB can be read");
  const std::size_t end = wordAt(source, 8);
  if (end > source.bytes.size()) {
    throw source.errorAtByte(
        8, fmt::format("says that the file has {} bytes, it has {}", end, source.bytes.size()));
  }
  const std::string_view text = chunkAt(source, 12, "JSON");
  const std::size_t next = 20 + text.size();
  using namespace std::string_view_literals;
  return {text, next < end ? chunkAt(source, next, "BIN\0"sv) : ""};
}

/// Keeps what geometry needs: images are neither looked for nor decoded, and what a broken file may
/// hold elsewhere does no harm.
bool isNeeded(int depth, json::parse_event_t event, const json& parsed) {
  if (event != json::parse_event_t::key) return depth < kDeepestNesting;
  const auto& key = parsed.get_ref<const std::string&>();
  return depth == 1 ? std::ranges::find(kNeededSections, key) != std::end(kNeededSections)
                    : key != "extras" && key != "extensions";
}

json parseJson(const MeshSource& source, std::string_view text) {
  try {
    json parsed = json::parse(text, isNeeded);
    if (parsed.is_object()) return parsed;
  } catch (const json::exception& problem) {
    const std::string_view what = problem.what();
    throw source.error(oneLine(what.substr(std::min(what.find("] ") + 2, what.size()))));
  }
  throw source.error("the JSON must be an object");
}

/// Compressed geometry is what required extensions can take away.
void requireUncompressed(const MeshSource& source, const json& gltf) {
  const json required = gltf.value("extensionsRequired", json::array());
  for (const char* const name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
    const auto isName = [&](const json& one) {
      return one.is_string() && one.get_ref<const std::string&>() == name;
    };
    if (std::ranges::any_of(required, isName)) {
      throw source.error(fmt::format("needs the extension {}, which cannot be read", name));
    }
  }
}

/// A GLB file's first buffer may have no URI: then it is the binary chunk.
void nameBinaryChunk(json& gltf, std::string_view& binary) {
  json& buffers = gltf["buffers"];
  if (binary.empty() || !buffers.is_array() || buffers.empty() || !buffers[0].is_object()) return;
  json& first = buffers[0];
  if (first.contains("uri")) return;
  first["uri"] = kBinaryChunk;
  const json& length = first["byteLength"];  // The chunk is padded to four bytes.
  if (length.is_number_unsigned()) binary = binary.substr(0, length.get<std::size_t>());
}

/// What tinygltf reads buffers through.
struct BufferFiles {
  const MeshSource& source;
  std::string_view binary;
  std::set<std::filesystem::path> read;
};

std::string keepPath(const std::string& path, void* /*user*/) { return path; }

bool saysExists(const std::string& /*path*/, void* /*user*/) { return true; }

/// Once each: many buffers of one file would take memory out of all proportion.
bool readBuffer(std::vector<unsigned char>* bytes, std::string* /*error*/, const std::string& uri,
                void* user) {
  auto& files = *static_cast<BufferFiles*>(user);
  const std::filesystem::path file = files.source.file.parent_path() / uri;
  std::error_code ignored;  // What cannot be resolved cannot be read either.
  if (!files.read.insert(std::filesystem::weakly_canonical(file, ignored)).second) {
    throw files.source.error(fmt::format("two buffers are the file {}", inQuotes(uri)));
  }
  const bool isChunk = uri == kBinaryChunk && !files.binary.empty();
  const std::string content = isChunk ? std::string(files.binary) : readMeshFile(file);
  bytes->assign(content.begin(), content.end());
  return true;
}

}  // namespace

tinygltf::Model readGltfModel(const MeshSource& source) {
  Chunks chunks = splitChunks(source);
  json gltf = parseJson(source, chunks.json);
  requireUncompressed(source, gltf);
  nameBinaryChunk(gltf, chunks.binary);
  const std::string text = gltf.dump();

  BufferFiles files{source, chunks.binary, {}};
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks({saysExists, keepPath, readBuffer, nullptr, &files});
  tinygltf::Model model;
  std::string error, warning;
  const bool isRead =
      loader.LoadASCIIFromString(&model, &error, &warning, text.data(), text.size(), "");
  if (!isRead || !error.empty()) throw source.error(oneLine(error));
  return model;
}

}  // namespace morphgrid
