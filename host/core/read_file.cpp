#include "core/read_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "core/error.h"

namespace morphgrid {

std::optional<std::string> whyUnreadable(const std::filesystem::path& file) {
  std::error_code ignored;  // What does not exist is no folder; opening it tells why.
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  if (std::filesystem::is_directory(status)) return "it is a folder";
  if (std::filesystem::is_other(status)) return "it is no regular file";
  errno = 0;
  if (std::ifstream(file, std::ios::binary)) return std::nullopt;
  return std::generic_category().message(errno);
}

std::string readFile(const std::filesystem::path& file, std::uintmax_t mostBytes) {
  if (const auto reason = whyUnreadable(file)) {
    throw InputError(fmt::format("{}: cannot be read: {}", file.string(), *reason));
  }
  std::error_code ignored;  // What cannot be sized is no larger than what is read.
  const std::uintmax_t size = std::filesystem::file_size(file, ignored);
  if (!ignored && size > mostBytes) {
    throw InputError(
        fmt::format("{}: must be of {} bytes at most, got {}", file.string(), mostBytes, size));
  }
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) {
    throw InputError(fmt::format("{}: cannot be read: the disk failed", file.string()));
  }
  return bytes;
}

}  // namespace morphgrid
