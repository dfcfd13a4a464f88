#include "core/array_file.h"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/read_file.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr ArrayFormat kSampleFormat{"morphgrid sample", 3, "sample", "make it again"};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// CRC-32 by its definition, a bit at a time.
std::uint32_t crc32Of(std::string_view bytes) {
  std::uint32_t sum = 0xffffffff;
  for (const char byte : bytes) {
    sum ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) {
      sum = (sum >> 1) ^ ((sum & 1) != 0 ? 0xedb88320 : 0);
    }
  }
  return ~sum;
}

template <typename T>
std::string bytesOf(T value) {
  std::string bytes;
  for (std::size_t n = 0; n < sizeof(T); ++n) {
    bytes += static_cast<char>(value >> (8 * n) & 0xff);
  }
  return bytes;
}

/// A file of that header and data with a checksum that is right.
std::string framed(const std::string& header, const std::string& data) {
  const std::string bytes = bytesOf<std::uint64_t>(header.size()) + header + data;
  return bytes + bytesOf(crc32Of(bytes));
}

class ArrayFileTest : public testing::Test {
 protected:
  std::filesystem::path writeSample() const {
    const double points[] = {0.1, -0.0, kInfinity, 5e-324, 1e308, std::nan("")};
    const std::int32_t numbers[] = {-1, 2147483647};
    const std::uint8_t flags[] = {0, 1, 255};
    const double one[] = {2.5};
    const auto file = folder_ / "sample.safetensors";
    writeArrayFile(file, kSampleFormat, {{"scene", "a = \"\\\n\"  # \u00fc"}, {"empty", ""}},
                   {{"points", viewOf({2, 3}, points)},
                    {"nothing", viewOf({0, 7}, std::span<const double>())},
                    {"one", viewOf({}, one)},
                    {"numbers", viewOf({2}, numbers)},
                    {"flags", viewOf({3, 1}, flags)}});
    return file;
  }

  /// What reading such bytes says.
  std::string problemOf(std::string_view bytes) const {
    const auto file = folder_.write("changed.safetensors", bytes);
    try {
      const ArrayFile read(file, kSampleFormat);
    } catch (const InputError& error) {
      return folder_.withoutPath(error.what());
    }
    return "";
  }

  /// What reading arrays says that are announced so and have a checksum that is right.
  std::string problemOfArrays(const std::string& entries, std::size_t dataBytes) const {
    return problemOf(
        framed(R"({"__metadata__":{"format":"morphgrid sample","version":"3"},)" + entries + "}",
               std::string(dataBytes, '\0')));
  }

  TemporaryFolder folder_;
};

constexpr const char* kDamagedSample =
    "changed.safetensors: the sample is damaged or cut short; make it again";

TEST_F(ArrayFileTest, GivesBackWhatWasWrittenBitByBit) {
  const ArrayFile file(writeSample(), kSampleFormat);
  EXPECT_EQ(file.text("scene"), "a = \"\\\n\"  # \u00fc");
  EXPECT_EQ(file.text("empty"), "");
  double points[6];
  file.copy("points", points);
  EXPECT_EQ(points[0], 0.1);
  EXPECT_TRUE(std::signbit(points[1]));
  EXPECT_EQ(points[2], kInfinity);
  EXPECT_EQ(points[3], 5e-324);
  EXPECT_EQ(points[4], 1e308);
  EXPECT_TRUE(std::isnan(points[5]));
  std::int32_t numbers[2];
  file.copy("numbers", numbers);
  EXPECT_THAT(numbers, testing::ElementsAre(-1, 2147483647));
  std::uint8_t flags[3];
  file.copy("flags", flags);
  EXPECT_THAT(flags, testing::ElementsAre(0, 1, 255));
  file.copy("nothing", std::span<double>());
  EXPECT_THAT(file.shapeOf("points"), testing::ElementsAre(2, 3));
  EXPECT_THAT(file.shapeOf("nothing"), testing::ElementsAre(0, 7));
  EXPECT_TRUE(file.shapeOf("one").empty());
  EXPECT_TRUE(file.has("flags"));
  EXPECT_FALSE(file.has("flag"));
}

TEST_F(ArrayFileTest, WhatIsNotThereOrOfAnotherTypeOrSizeIsDamage) {
  const ArrayFile file(writeSample(), kSampleFormat);
  double numbers[2];
  double points[5];
  EXPECT_THROW(file.copy("numbers", numbers), InputError);
  EXPECT_THROW(file.copy("points", points), InputError);
  EXPECT_THROW(file.copy("crc", points), InputError);
  EXPECT_THROW(file.shapeOf("crc"), InputError);
  EXPECT_THROW(file.text("points"), InputError);
}

TEST_F(ArrayFileTest, IsSafetensorsWithAChecksum) {
  const std::string bytes = readFile(writeSample());
  std::uint64_t length = 0;
  for (std::size_t n = 8; n-- > 0;) {
    length = length << 8 | static_cast<unsigned char>(bytes[n]);
  }
  EXPECT_EQ(length % 8, 0u) << "the arrays are aligned";
  const json header = json::parse(bytes.substr(8, length));
  const std::string data = bytes.substr(8 + length);
  EXPECT_EQ(header["__metadata__"]["format"], "morphgrid sample");
  EXPECT_EQ(header["__metadata__"]["version"], "3");
  EXPECT_EQ(header["points"], json::parse(R"({"dtype": "F64", "shape": [2, 3],
                                              "data_offsets": [0, 48]})"));
  EXPECT_EQ(header["numbers"]["dtype"], "I32");
  EXPECT_EQ(header["flags"]["dtype"], "U8");
  EXPECT_EQ(data.substr(0, 8), bytesOf(std::bit_cast<std::uint64_t>(0.1)));
  EXPECT_EQ(header["crc32"]["dtype"], "U32");
  EXPECT_EQ(header["crc32"]["data_offsets"], (json{data.size() - 4, data.size()}));
  EXPECT_EQ(bytes.substr(bytes.size() - 4), bytesOf(crc32Of(bytes.substr(0, bytes.size() - 4))));
}

TEST_F(ArrayFileTest, EveryFlippedBitIsFound) {
  const std::string bytes = readFile(writeSample());
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const int bit : {0, 3, 7}) {
      std::string changed = bytes;
      changed[at] = static_cast<char>(changed[at] ^ (1 << bit));
      ASSERT_THAT(problemOf(changed), HasSubstr("; make it again")) << at << ", " << bit;
    }
  }
}

TEST_F(ArrayFileTest, EveryTruncationIsFound) {
  const std::string bytes = readFile(writeSample());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ASSERT_THAT(problemOf(std::string_view(bytes).substr(0, size)), HasSubstr("; make it again"))
        << size;
  }
  EXPECT_EQ(problemOf(std::string_view(bytes).substr(0, bytes.size() - 1)), kDamagedSample);
  EXPECT_EQ(problemOf(bytes + '\0'), kDamagedSample);
  EXPECT_EQ(problemOf(bytes), "");
}

TEST_F(ArrayFileTest, OtherFilesAreToldApart) {
  constexpr const char* kForeign = "changed.safetensors: is no sample of morphgrid; make it again";
  EXPECT_EQ(problemOf(""), kForeign);
  EXPECT_EQ(problemOf("[surface]\nkind = \"bezier\"\n"), kForeign);
  EXPECT_EQ(problemOf(std::string(1000, '\0')), kForeign);
  EXPECT_EQ(problemOf(framed(R"({"weight":{"dtype":"F64","shape":[0],"data_offsets":[0,0]}})", "")),
            kForeign);
  EXPECT_THROW(ArrayFile("/dev/zero", kSampleFormat), InputError);
  EXPECT_THROW(ArrayFile(folder_.path(), kSampleFormat), InputError);
  EXPECT_THROW(ArrayFile(folder_ / "missing", kSampleFormat), InputError);
  EXPECT_FALSE(looksLike(kSampleFormat, folder_ / "missing"));
  EXPECT_FALSE(looksLike(kSampleFormat, folder_.path()));
  EXPECT_FALSE(looksLike(kSampleFormat, folder_.write("scene.toml", "kind = 1")));
  EXPECT_TRUE(looksLike(kSampleFormat, writeSample()));
}

TEST_F(ArrayFileTest, AnotherVersionIsNamed) {
  const auto file = folder_ / "newer.safetensors";
  writeArrayFile(file, {"morphgrid sample", 4, "sample", ""}, {}, {});
  try {
    const ArrayFile read(file, kSampleFormat);
    FAIL() << "read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("the sample has version 4, this morphgrid reads version 3"));
    EXPECT_THAT(error.what(), HasSubstr("make it again"));
  }
}

TEST_F(ArrayFileTest, HeadersThatContradictThemselvesAreDamage) {
  constexpr const char* kSum = R"("crc32":{"dtype":"U32","shape":[1],"data_offsets":[8,12]})";
  const auto withArray = [&](const std::string& entry) {
    return problemOfArrays(R"("a":)" + entry + "," + kSum, 8);
  };
  EXPECT_EQ(withArray(R"({"dtype":"F64","shape":[1],"data_offsets":[0,8]})"), "");
  for (const char* entry : {
           R"({"dtype":"F64","shape":[2],"data_offsets":[0,8]})",
           R"({"dtype":"F64","shape":[1],"data_offsets":[0,16]})",
           R"({"dtype":"F64","shape":[1],"data_offsets":[8,0]})",
           R"({"dtype":"F64","shape":[1],"data_offsets":[0]})",
           R"({"dtype":"F64","shape":[1],"data_offsets":8})",
           R"({"dtype":"F64","shape":[-1],"data_offsets":[0,-8]})",
           R"({"dtype":"F64","shape":[1.5],"data_offsets":[0,8]})",
           R"({"dtype":"F64","shape":["1"],"data_offsets":[0,8]})",
           R"({"dtype":"F64","shape":1,"data_offsets":[0,8]})",
           R"({"dtype":"F64","shape":[4294967296,4294967296,1],"data_offsets":[0,0]})",
           R"({"dtype":"F64","shape":[2305843009213693953],"data_offsets":[0,8]})",
           R"({"dtype":"F16","shape":[4],"data_offsets":[0,8]})",
           R"({"dtype":8,"shape":[1],"data_offsets":[0,8]})",
           R"({"shape":[1],"data_offsets":[0,8]})",
           R"({"dtype":"F64","shape":[0],"data_offsets":[0,0]})",
           R"("F64")",
           R"(null)",
       }) {
    EXPECT_EQ(withArray(entry), kDamagedSample) << entry;
  }
  const std::string all = R"("a":{"dtype":"U8","shape":[12],"data_offsets":[0,12]})";
  EXPECT_EQ(problemOfArrays(all, 8), kDamagedSample) << "no checksum";
  EXPECT_EQ(problemOfArrays(all + "," + kSum, 8), kDamagedSample) << "overlapping";
  const std::string mark = R"({"__metadata__":{"format":"morphgrid sample",)";
  for (const std::string& header : {mark, mark + R"("version":3})", mark + R"("version":"3"},)"}) {
    EXPECT_EQ(problemOf(framed(header, "")), kDamagedSample) << header;
  }
}

TEST_F(ArrayFileTest, HostileHeadersEndSoon) {
  const std::string mark = R"({"__metadata__":{"format":"morphgrid sample",)";
  EXPECT_EQ(problemOf(framed(mark + R"("version":)" + std::string(1 << 20, '['), "")),
            kDamagedSample);
  std::string many = mark + R"("version":"3"})";
  for (int n = 0; n < 100000; ++n) {
    many += ",\"" + std::to_string(n) + "\":1";
  }
  EXPECT_EQ(problemOf(framed(many + "}", "")), kDamagedSample);
  std::string huge = framed(mark, "");
  for (const std::uint64_t length : {std::uint64_t{1} << 63, ~std::uint64_t{}, std::uint64_t{0}}) {
    huge.replace(0, 8, bytesOf(length));
    EXPECT_EQ(problemOf(huge), kDamagedSample) << length;
  }
}

TEST_F(ArrayFileTest, WhatCannotBeWrittenIsTold) {
  EXPECT_THROW(writeArrayFile(folder_ / "missing" / "file", kSampleFormat, {}, {}), InputError);
  EXPECT_THROW(
      writeArrayFile(folder_ / "file", kSampleFormat, {{"text", std::string(1 << 24, ' ')}}, {}),
      InputError);
  EXPECT_EQ(folder_.fileCount(), 0);
}

TEST_F(ArrayFileTest, TextsThatAreNoUtf8AreMended) {
  writeArrayFile(folder_ / "file", kSampleFormat,
                 {{"path",
                   "a\xff"
                   "b"}},
                 {});
  EXPECT_EQ(ArrayFile(folder_ / "file", kSampleFormat).text("path"),
            "a\xef\xbf\xbd"
            "b");
}

}  // namespace
}  // namespace morphgrid
