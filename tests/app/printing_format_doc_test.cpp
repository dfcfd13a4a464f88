#include <gtest/gtest.h>

#include "app/print_document.h"
#include "core/read_file.h"
#include "tests/support/folders.h"

namespace morphgrid {
namespace {

TEST(PrintingFormatDoc, HasTheKeysAsTheyAre) {
  const std::string document = readFile(sourceFolder() / "docs/printing_format.md");
  EXPECT_EQ(document, withPrintKeys(document))
      << "cmake --build build/release --target scene_format writes them";
}

}  // namespace
}  // namespace morphgrid
