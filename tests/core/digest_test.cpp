#include "core/digest.h"

#include <gtest/gtest.h>

#include <vector>

namespace morphgrid {
namespace {

using namespace std::string_view_literals;

TEST(Digest, IsThatOfThePublishedValues) {
  EXPECT_EQ(Digest().text(), "cbf29ce484222325");
  EXPECT_EQ(Digest().add("a"sv).text(), "af63dc4c8601ec8c");
  EXPECT_EQ(Digest().add("foobar"sv).text(), "85944171f73967e8");
  EXPECT_EQ(Digest().add("foo"sv).add("bar"sv).text(), "85944171f73967e8");
}

TEST(Digest, TakesNumbersAsTheirBytes) {
  EXPECT_EQ(Digest().add(std::int64_t{0x6f6f66}).text(), Digest().add("foo\0\0\0\0\0"sv).text());
  EXPECT_EQ(Digest().add(1.0).text(), Digest().add("\0\0\0\0\0\0\xf0\x3f"sv).text());
  EXPECT_NE(Digest().add(0.0).text(), Digest().add(-0.0).text());
}

TEST(Digest, TellsListsApartThatFollowEachOther) {
  const std::vector<double> one{1}, two{1, 1}, three{1, 1, 1};
  EXPECT_NE(Digest().addList(one).addList(three).text(), Digest().addList(two).addList(two).text());
  EXPECT_NE(Digest().addList("ab"sv).addList("c"sv).text(),
            Digest().addList("a"sv).addList("bc"sv).text());
}

}  // namespace
}  // namespace morphgrid
