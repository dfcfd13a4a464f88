#include "core/create_folder.h"

#include <fmt/format.h>

#include <system_error>

#include "core/error.h"

namespace morphgrid {

void createFolder(const std::filesystem::path& folder, const std::string& subject) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw InputError(fmt::format("{}: the folder cannot be made: {}", subject, error.message()));
  }
}

}  // namespace morphgrid
