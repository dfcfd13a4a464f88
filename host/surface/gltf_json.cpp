#include "surface/gltf_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace morphgrid {
namespace {

using nlohmann::json;

const int kDeepestNesting = 32;  ///< glTF itself needs 6; tinygltf recurses.

const std::string_view kNeededSections[] = {
    "asset", "scene",     "scenes",      "nodes",   "meshes",
    "skins", "accessors", "bufferViews", "buffers", "extensionsRequired"};

const char* const kVisibility = "KHR_node_visibility";

/// Extensions that are read, or move no triangle. What ends in _ stands for all that begin so.
const std::string_view kHarmlessExtensions[] = {"KHR_mesh_quantization",
                                                "KHR_node_visibility",
                                                "KHR_node_hoverability",
                                                "KHR_animation_",
                                                "KHR_node_selectability",
                                                "KHR_audio_",
                                                "KHR_lights_",
                                                "KHR_materials_",
                                                "KHR_texture_",
                                                "KHR_xmp_",
                                                "EXT_lights_",
                                                "EXT_texture_",
                                                "MSFT_texture_dds",
                                                "ADOBE_materials_"};

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

Chunks splitChunks(const MeshSource& source) {
  if (!source.bytes.starts_with("glTF")) return {source.bytes, {}};
  if (const std::uint32_t version = wordAt(source, 4); version != 2) {
    throw source.errorAtByte(
        4, fmt::format("is GLB of version {}, which cannot be read: only version 2 can", version));
  }
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
/// hold elsewhere does no harm. Extensions stay for the items of sections, at depth 3.
bool isNeeded(int depth, json::parse_event_t event, const json& parsed) {
  if (event != json::parse_event_t::key) return depth < kDeepestNesting;
  const auto& key = parsed.get_ref<const std::string&>();
  if (depth == 1) return std::ranges::find(kNeededSections, key) != std::end(kNeededSections);
  return key != "extras" && (key != "extensions" || depth == 3);
}

/// Leaves the extensions of nodes, of these one, and no others.
void dropExtensions(json& gltf) {
  for (auto& [name, section] : gltf.items()) {
    if (!section.is_array()) continue;
    for (json& item : section) {
      if (!item.is_object() || !item.contains("extensions")) continue;
      const json extensions = std::move(item["extensions"]);
      item.erase("extensions");
      if (name == "nodes" && extensions.is_object() && extensions.contains(kVisibility)) {
        item["extensions"] = {{kVisibility, extensions[kVisibility]}};
      }
    }
  }
}

json parseJson(const MeshSource& source, std::string_view text) {
  source.refuseUtf16();
  try {
    json parsed = json::parse(text, isNeeded);
    if (parsed.is_object()) return parsed;
  } catch (const json::exception& problem) {
    const std::string_view what = problem.what();
    throw source.error(oneLine(what.substr(std::min(what.find("] ") + 2, what.size()))));
  }
  throw source.error("the JSON must be an object");
}

bool isHarmless(std::string_view extension) {
  return std::ranges::any_of(kHarmlessExtensions, [&](std::string_view known) {
    return known.ends_with('_') ? extension.starts_with(known) : extension == known;
  });
}

/// The specification has readers refuse what requires an extension that they do not know.
void requireKnownExtensions(const MeshSource& source, const json& gltf) {
  const auto required = gltf.find("extensionsRequired");
  if (required == gltf.end()) return;
  for (const json& one : *required) {
    const std::string name = one.is_string() ? one.get<std::string>() : one.dump();
    if (isHarmless(name)) continue;
    const bool isCompression = name.find("compression") != std::string::npos;
    throw source.error(fmt::format("needs the extension {}, which cannot be read{}", oneLine(name),
                                   isCompression ? ": export it without compression" : ""));
  }
}

void requireVersion(const MeshSource& source, const json& gltf) {
  const json asset = gltf.value("asset", json::object());
  const auto version = asset.is_object() ? asset.find("version") : asset.end();
  if (version == asset.end() || !version->is_string()) {
    throw source.error("is no glTF: asset.version must be a string, e.g. \"2.0\"");
  }
  const std::string text = version->get<std::string>();
  if (text.starts_with("2.")) return;
  throw source.error(
      fmt::format("is glTF {}, which cannot be read: only version 2 can", oneLine(text)));
}

}  // namespace

GltfJson parseGltf(const MeshSource& source) {
  const Chunks chunks = splitChunks(source);
  GltfJson gltf{parseJson(source, chunks.json), chunks.binary};
  requireVersion(source, gltf.json);
  requireKnownExtensions(source, gltf.json);
  dropExtensions(gltf.json);
  return gltf;
}

}  // namespace morphgrid
