#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace morphgrid {

/// Why a file cannot be read, e.g. "No such file or directory"; nothing when it can.
std::optional<std::string> whyUnreadable(const std::filesystem::path& file);

/// The bytes of a file. Throws InputError `file: cannot be read: why`.
std::string readFile(const std::filesystem::path& file);

}  // namespace morphgrid
