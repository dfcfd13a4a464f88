#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

#include "surface/mesh_formats.h"
#include "surface/text_reader.h"

static_assert(std::endian::native == std::endian::little, "binary STL is little endian");

namespace morphgrid {
namespace {

// A binary file: 80 bytes of header, the number of facets, then per facet a normal and three
// corners of three floats each and two spare bytes.
const std::size_t kCountOffset = 80;
const std::size_t kFacetsOffset = 84;
const std::size_t kFacetBytes = 50;
const std::size_t kNormalBytes = 12;

/// What a conversion of text makes of bytes above 127 that are none: U+FFFD in UTF-8.
const std::string_view kReplacement = "\xef\xbf\xbd";

/// Three corners a facet, in turn; nothing is shared.
TriangleMesh meshOfFacets(Eigen::Matrix3Xd corners) {
  TriangleMesh mesh;
  mesh.triangles.resize(3, corners.cols() / 3);
  mesh.triangles.reshaped().setLinSpaced(0, static_cast<int>(corners.cols()) - 1);
  mesh.vertices = std::move(corners);
  return mesh;
}

/// How many bytes a binary file of as many facets as it says has; those of the header when that is
/// cut.
std::size_t binarySize(std::string_view bytes) {
  if (bytes.size() < kFacetsOffset) return kFacetsOffset;
  std::uint32_t facets = 0;
  std::memcpy(&facets, bytes.data() + kCountOffset, sizeof(facets));
  return kFacetsOffset + kFacetBytes * std::size_t{facets};
}

/// Whether bytes above 127 occur as replacements alone.
bool wasConvertedAsText(std::string_view bytes) {
  bool hasReplacement = false;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (static_cast<unsigned char>(bytes[i]) < 128) continue;
    if (bytes.substr(i, kReplacement.size()) != kReplacement) return false;
    hasReplacement = true;
    i += kReplacement.size() - 1;
  }
  return hasReplacement;
}

/// More than its size may follow: modellers add blocks of their own. What grew because it was
/// converted as text is damaged.
std::vector<std::string> noticesBehind(const MeshSource& source, std::size_t size) {
  const std::size_t left = source.bytes.size() - size;
  if (left == 0) return {};
  if (wasConvertedAsText(source.bytes.substr(kFacetsOffset))) {
    throw source.errorAtByte(source.bytes.find(kReplacement, kFacetsOffset),
                             "the binary STL file was converted as if it were text: bytes of it "
                             "were replaced by U+FFFD");
  }
  return {fmt::format("passed over {} behind the {} that the header counts", countOf(left, "byte"),
                      countOf((size - kFacetsOffset) / kFacetBytes, "facet"))};
}

NotedMesh readBinary(const MeshSource& source, std::size_t size) {
  const std::size_t facets = (size - kFacetsOffset) / kFacetBytes;
  std::vector<std::string> notices = noticesBehind(source, size);
  Eigen::Matrix3Xd corners(3, 3 * facets);
  for (std::size_t i = 0; i < facets; ++i) {
    const std::size_t offset = kFacetsOffset + kFacetBytes * i + kNormalBytes;
    Eigen::Matrix3f facet;
    std::memcpy(facet.data(), source.bytes.data() + offset, sizeof(facet));
    if (!facet.allFinite()) {
      throw source.errorAtByte(offset, fmt::format("facet {}: coordinates must be finite", i));
    }
    corners.middleCols<3>(3 * i) = facet.cast<double>();
  }
  return {meshOfFacets(std::move(corners)), std::move(notices)};
}

/// Reads `solid NAME`, facets and `endsolid NAME`, once or more, in capitals or not. Normals are
/// passed over: many files have wrong ones or none.
class AsciiReader {
 public:
  explicit AsciiReader(const MeshSource& source) : text_(source) {}

  TriangleMesh read() {
    for (std::string_view word = text_.wordOfAnyLine(); !word.empty();
         word = text_.wordOfAnyLine()) {
      require("solid", word);
      readSolid();
    }
    return meshOfFacets(Eigen::Matrix3Xd::Map(coordinates_.data(), 3, coordinates_.size() / 3));
  }

 private:
  void readSolid() {
    text_.skipLine();
    std::string_view word = text_.wordOfAnyLine();
    for (; isSameWithoutCase(word, "facet"); word = text_.wordOfAnyLine()) readFacet();
    require("endsolid", word, "facet or ");
    text_.skipLine();
  }

  void readFacet() {
    std::string_view word = text_.wordOfAnyLine();
    while (!word.empty() && !isSameWithoutCase(word, "outer")) word = text_.wordOfAnyLine();
    require("outer", word);
    require("loop", text_.wordOfAnyLine());
    for (int corner = 0; corner < 3; ++corner) readCorner();
    require("endloop", text_.wordOfAnyLine(), "after three vertices ");
    require("endfacet", text_.wordOfAnyLine());
  }

  void readCorner() {
    require("vertex", text_.wordOfAnyLine());
    for (const char* const name : {"x", "y", "z"}) {
      coordinates_.push_back(text_.number(text_.wordOfAnyLine(), name));
    }
  }

  void require(std::string_view wanted, std::string_view word, std::string_view before = "") const {
    if (isSameWithoutCase(word, wanted)) return;
    throw text_.error(fmt::format("{}{} expected, got {}", before, wanted,
                                  word.empty() ? "the end of the file" : inQuotes(word)));
  }

  TextReader text_;
  std::vector<double> coordinates_;
};

InputError sizeError(const MeshSource& source, std::size_t wanted) {
  const bool hasCount = source.bytes.size() >= kFacetsOffset;
  return source.errorAtByte(
      hasCount ? kCountOffset : 0,
      fmt::format(
          "a binary STL file {} {} bytes{}, got {}; an ASCII one would begin with \"solid\"",
          hasCount ? "with this number of facets takes" : "takes", wanted,
          hasCount ? "" : " at least", source.bytes.size()));
}

}  // namespace

NotedMesh readStl(const MeshSource& source) {
  // Binary files may begin with "solid" too: their size tells, for no text counts so few facets.
  const std::size_t size = binarySize(source.bytes);
  const bool hasFacets = size > kFacetsOffset;
  if (source.bytes.size() == size || (source.bytes.size() > size && hasFacets)) {
    return readBinary(source, size);
  }
  TextReader text(source);
  if (isSameWithoutCase(text.wordOfAnyLine().substr(0, 5), "solid")) {
    return {AsciiReader(source).read(), {}};
  }
  throw sizeError(source, size);
}

}  // namespace morphgrid
