#include "tests/support/folders.h"

namespace morphgrid {

std::filesystem::path sourceFolder() { return MORPHGRID_SOURCE_DIR; }

std::filesystem::path binaryFolder() { return MORPHGRID_BINARY_DIR; }

}  // namespace morphgrid
