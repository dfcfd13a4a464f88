#include "report/generated_block.h"

#include <gmock/gmock.h>

#include "core/error.h"

namespace morphgrid {
namespace {

constexpr const char* kDocument =
    "Words.\n<!-- begin a -->\nold\n<!-- end a -->\nMore.\n<!-- begin b -->\n<!-- end b -->\n";

TEST(GeneratedBlock, IsAllThatChanges) {
  EXPECT_EQ(withBlock(kDocument, "a", "new\nlines\n"),
            "Words.\n<!-- begin a -->\nnew\nlines\n<!-- end a -->\nMore.\n<!-- begin b -->\n"
            "<!-- end b -->\n");
  EXPECT_EQ(withBlock(withBlock(kDocument, "b", "x\n"), "b", ""), kDocument);
}

TEST(GeneratedBlock, MustBeThere) {
  for (const char* document :
       {"", "<!-- begin a -->\n", "<!-- end a -->\n<!-- begin a -->\n", "<!-- begin a -->"}) {
    SCOPED_TRACE(document);
    EXPECT_THROW(withBlock(document, "a", ""), InputError);
  }
}

}  // namespace
}  // namespace morphgrid
