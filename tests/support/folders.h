#pragma once
#include <filesystem>

namespace morphgrid {

/// The checkout, where CMakeLists.txt lies.
std::filesystem::path sourceFolder();

/// Where it is built, with the program in it.
std::filesystem::path binaryFolder();

}  // namespace morphgrid
