#include "core/visible_text.h"

#include <gtest/gtest.h>

namespace morphgrid {
namespace {

TEST(VisibleText, WritesControlCharactersOut) {
  EXPECT_EQ(visibleText("a\x1b[31mb\r\n\t\x7f"), "a\\x1b[31mb\\x0d\\x0a\\x09\\x7f");
  EXPECT_EQ(visibleText(std::string_view("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(visibleText("a\xc2\x9b"
                        "31m"),
            "a\\x9b31m");  // U+009B begins sequences, too.
  EXPECT_EQ(visibleText("\xc2"), "\xc2");
}

TEST(VisibleText, KeepsLettersAndWhatItIsToldTo) {
  EXPECT_EQ(visibleText("Größe \xc2\xa0 \xe2\x82\xac"), "Größe \xc2\xa0 \xe2\x82\xac");
  EXPECT_EQ(visibleText("a\nb\tc", "\n"), "a\nb\\x09c");
}

}  // namespace
}  // namespace morphgrid
