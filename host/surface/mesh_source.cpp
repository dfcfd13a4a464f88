#include "surface/mesh_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/read_file.h"

namespace morphgrid {
namespace {

/// A broken file's bytes must not reach a terminal as they are.
std::string printable(std::string_view text, std::size_t mostCharacters) {
  std::string result(text.substr(0, mostCharacters));
  std::replace_if(
      result.begin(), result.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  if (text.size() > mostCharacters) result += "...";
  return result;
}

/// ASCII letters as UTF-16: every other byte is 0.
bool hasTwoBytesALetter(std::string_view text) {
  if (text.size() < 4 || (text[0] == '\0') == (text[1] == '\0')) return false;
  for (std::size_t i = 2; i < text.size(); ++i) {
    if ((text[i] == '\0') != (text[i - 2] == '\0')) return false;
  }
  return true;
}

}  // namespace

InputError MeshSource::error(std::string_view what) const {
  return InputError(fmt::format("{}: {}", file.string(), what));
}

InputError MeshSource::errorAtLine(int line, std::string_view what) const {
  return InputError(fmt::format("{}:{}: {}", file.string(), line, what));
}

InputError MeshSource::errorAtByte(std::size_t offset, std::string_view what) const {
  return error(fmt::format("byte {}: {}", offset, what));
}

void MeshSource::refuseUtf16() const {
  using namespace std::string_view_literals;
  const std::string_view start = bytes.substr(0, 2);
  const bool isMarked = start == "\xff\xfe"sv || start == "\xfe\xff"sv;
  if (isMarked || hasTwoBytesALetter(bytes.substr(0, 8))) {
    throw error("is UTF-16 text, which cannot be read: save it as UTF-8");
  }
}

InputError pointCloudError(const MeshSource& source, std::size_t points) {
  return source.error(fmt::format("holds {} but no faces: a point cloud must be meshed first",
                                  countOf(points, "point")));
}

std::string readMeshFile(const std::filesystem::path& file) {
  return readFile(file, kMostMeshBytes);
}

bool isSameWithoutCase(std::string_view a, std::string_view b) {
  const auto lower = [](unsigned char c) { return std::tolower(c); };
  return std::ranges::equal(a, b, {}, lower, lower);
}

std::string countOf(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string inQuotes(std::string_view text) { return '"' + printable(text, 32) + '"'; }

std::string oneLine(std::string_view text) {
  return printable(text.substr(0, text.find('\n')), 200);
}

}  // namespace morphgrid
