#include "surface/data_uri.h"

#include <gtest/gtest.h>

namespace morphgrid {
namespace {

TEST(DataUri, IsDecodedInEveryForm) {
  for (const char* const uri :
       {"data:application/octet-stream;base64,aGVsbG8=",
        "data:application/gltf-buffer;base64,aGVsbG8=", "data:;base64,aGVsbG8=",
        "data:;base64,aGVsbG8",
        "DATA:text/plain;charset=utf-8;BASE64,aGVsbG8=", "data:;base64,aGVs%62G8%3D",
        "data:;base64,aGVs\n bG8=", "data:,hello", "data:text/plain,he%6Clo"}) {
    ASSERT_TRUE(isDataUri(uri)) << uri;
    EXPECT_EQ(decodeDataUri(uri), "hello") << uri;
  }
  EXPECT_EQ(decodeDataUri("data:;base64,AP+/"), std::string("\0\xff\xbf", 3));
  EXPECT_EQ(decodeDataUri("data:;base64,"), "");
  EXPECT_EQ(decodeDataUri("data:,100%"), "100%");
}

TEST(DataUri, IsRefusedWhenMalformed) {
  for (const char* const uri : {"data:;base64", "data:;base64,A", "data:;base64,AA*A",
                                "data:;base64,AAAAA", "data:;base64,A=AA", "data"}) {
    EXPECT_EQ(decodeDataUri(uri), std::nullopt) << uri;
  }
  EXPECT_FALSE(isDataUri("data/a.bin"));
  EXPECT_FALSE(isDataUri(""));
}

}  // namespace
}  // namespace morphgrid
