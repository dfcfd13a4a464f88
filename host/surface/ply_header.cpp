#include "surface/ply_header.h"

#include <fmt/format.h>

#include <charconv>

namespace morphgrid {
namespace {

struct TypeName {
  const char* name;
  PlyType type;
};

const TypeName kTypeNames[] = {
    {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
    {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
    {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
    {"float64", PlyType::float64}};

PlyType typeOf(const TextReader& text, std::string_view word) {
  for (const TypeName& known : kTypeNames) {
    if (word == known.name) return known.type;
  }
  throw text.error(
      fmt::format("a type must be char, uchar, short, ushort, int, uint, float or double, got {}",
                  inQuotes(word)));
}

PlyFormat readFormat(TextReader& text) {
  const std::string_view word = text.word();
  if (word == "ascii") return PlyFormat::ascii;
  if (word == "binary_little_endian") return PlyFormat::binaryLittleEndian;
  if (word == "binary_big_endian") return PlyFormat::binaryBigEndian;
  throw text.error(
      fmt::format("the format must be ascii, binary_little_endian or binary_big_endian, got {}",
                  inQuotes(word)));
}

PlyElement readElement(TextReader& text) {
  PlyElement element{std::string(text.word()), 0, {}};
  const std::string_view word = text.word();
  const auto [end, problem] =
      std::from_chars(word.data(), word.data() + word.size(), element.rowCount);
  if (problem == std::errc() && end == word.data() + word.size()) return element;
  throw text.error(fmt::format("the number of {} must be an integer >= 0, got {}",
                               inQuotes(element.name), inQuotes(word)));
}

PlyProperty readProperty(TextReader& text) {
  PlyProperty property;
  std::string_view word = text.word();
  if (word == "list") {
    property.countType = typeOf(text, text.word());
    if (*property.countType >= PlyType::float32) throw text.error("a list's count must be integer");
    word = text.word();
  }
  property.type = typeOf(text, word);
  property.name = text.word();
  return property;
}

}  // namespace

std::size_t byteCount(PlyType type) {
  const std::size_t counts[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return counts[static_cast<int>(type)];
}

PlyHeader readPlyHeader(TextReader& text) {
  PlyHeader header;
  if (!text.nextLine() || text.word() != "ply") throw text.error("a PLY file must begin with ply");
  bool hasFormat = false;
  while (text.nextLine()) {
    const std::string_view keyword = text.word();
    if (keyword == "end_header") {
      if (!hasFormat) throw text.error("the header lacks the line format");
      return header;
    }
    if (keyword == "format") {
      header.format = readFormat(text);
      hasFormat = true;
    } else if (keyword == "element") {
      header.elements.push_back(readElement(text));
    } else if (keyword == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(readProperty(text));
    } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
      throw text.error(fmt::format(
          "format, element, property (after an element), comment, obj_info or end_header expected, "
          "got {}",
          inQuotes(keyword)));
    }
  }
  throw text.error("the header lacks the line end_header");
}

}  // namespace morphgrid
