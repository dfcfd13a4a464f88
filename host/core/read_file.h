#pragma once
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>

namespace morphgrid {

/// Why a file cannot be read, e.g. "No such file or directory"; nothing when it can. Only regular
/// files are read: a pipe would be waited for, and a device need not end.
std::optional<std::string> whyUnreadable(const std::filesystem::path& file);

/// The bytes of a file. Throws InputError `file: cannot be read: why`, also where there are more
/// than mostBytes.
std::string readFile(const std::filesystem::path& file,
                     std::uintmax_t mostBytes = std::numeric_limits<std::uintmax_t>::max());

}  // namespace morphgrid
