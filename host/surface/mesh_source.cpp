#include "surface/mesh_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

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

std::string readMeshFile(const std::filesystem::path& file) {
  const MeshSource source{file, {}};
  std::error_code ignored;  // What does not exist or is a folder, readFile refuses.
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  if (std::filesystem::is_other(status)) throw source.error("cannot be read: no regular file");
  const std::uintmax_t size = std::filesystem::file_size(file, ignored);
  if (std::filesystem::is_regular_file(status) && size > kMostMeshBytes) {
    throw source.error(fmt::format("must be of {} bytes at most, got {}", kMostMeshBytes, size));
  }
  return readFile(file);
}

std::string inQuotes(std::string_view text) { return '"' + printable(text, 32) + '"'; }

std::string oneLine(std::string_view text) {
  return printable(text.substr(0, text.find('\n')), 200);
}

}  // namespace morphgrid
