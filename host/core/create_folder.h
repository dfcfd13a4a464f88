#pragma once
#include <filesystem>
#include <string>

namespace morphgrid {

/// Makes a folder and those above it that are missing. Throws InputError that begins with
/// `subject`, what the user gave, when that is not possible.
void createFolder(const std::filesystem::path& folder, const std::string& subject);

}  // namespace morphgrid
