#pragma once
#include <map>
#include <string>

namespace morphgrid {

/// The files in a ZIP archive, unpacked, by name. Throws std::runtime_error when it is none.
std::map<std::string, std::string> readZip(const std::string& bytes);

}  // namespace morphgrid
