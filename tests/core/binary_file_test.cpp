#include "core/binary_file.h"

#include <gmock/gmock.h>

#include <limits>

#include "core/error.h"
#include "core/read_file.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

constexpr BinaryFormat kFormat{"sample", 7, "make it anew"};

struct Sample {
  std::int64_t integer;
  double number;
  std::string text;
  std::vector<double> numbers;
  Eigen::VectorXd vector;
  Eigen::Matrix3Xd points;

  bool operator==(const Sample&) const = default;
};

Sample sample() {
  return {-5,
          std::numeric_limits<double>::denorm_min(),
          std::string("a\0\nb", 4),
          {1.0 / 3, -0.0},
          Eigen::VectorXd::LinSpaced(4, 0, 1),
          Eigen::Matrix3Xd::Random(3, 5)};
}

BinaryWriter written(const Sample& s) {
  BinaryWriter writer;
  writer.integer(s.integer).number(s.number).text(s.text).numbers(s.numbers);
  writer.numbers(s.vector).points(s.points);
  return writer;
}

Sample take(BinaryReader& reader) {
  Sample s;
  s.integer = reader.integer(-5, 5);
  s.number = reader.number();
  s.text = reader.text();
  s.numbers = reader.numbers();
  s.vector = reader.vector();
  s.points = reader.points();
  return s;
}

class BinaryFileTest : public testing::Test {
 protected:
  std::filesystem::path file() const { return folder_ / "a.sample"; }
  /// What reading complains of; empty when it does not.
  std::string problemOf(const std::string& bytes) const {
    try {
      readBinaryFile(folder_.write("other.sample", bytes), kFormat, take);
    } catch (const InputError& error) {
      return folder_.withoutPath(error.what());
    }
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(BinaryFileTest, KeepsEveryBit) {
  const Sample original = sample();
  writeBinaryFile(file(), kFormat, written(original));
  EXPECT_TRUE(readBinaryFile(file(), kFormat, take) == original);
  EXPECT_TRUE(isBinaryFile(file(), kFormat));
  EXPECT_FALSE(isBinaryFile(file(), {"other", 7, ""}));
  EXPECT_EQ(folder_.fileCount(), 1);
}

TEST_F(BinaryFileTest, CutShortAnywhereIsRefused) {
  writeBinaryFile(file(), kFormat, written(sample()));
  const std::string bytes = readFile(file());
  for (std::size_t count = 0; count < bytes.size(); ++count) {
    ASSERT_NE(problemOf(bytes.substr(0, count)), "") << count << " bytes";
  }
  EXPECT_THAT(problemOf(bytes.substr(0, bytes.size() / 2)),
              HasSubstr("the sample is damaged or cut short; make it anew"));
}

TEST_F(BinaryFileTest, WrongBytesAreRefused) {
  writeBinaryFile(file(), kFormat, written(sample()));
  const std::string bytes = readFile(file());
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    std::string damaged = bytes;
    damaged[n] = static_cast<char>(damaged[n] ^ 0x10);
    ASSERT_NE(problemOf(damaged), "") << "byte " << n;
  }
  EXPECT_THAT(problemOf(bytes + "x"), HasSubstr("damaged"));
}

TEST_F(BinaryFileTest, OtherKindsAndVersionsAreRefused) {
  EXPECT_THAT(problemOf("[surface]\n"), HasSubstr("is no sample of morphgrid; make it anew"));
  EXPECT_THAT(problemOf(""), HasSubstr("is no sample of morphgrid"));
  EXPECT_THAT(problemOf("morphgrid sample 8\n"),
              HasSubstr("has format 8, this morphgrid reads format 7"));
}

// The checksum holds, but what was written is not what is read.
TEST_F(BinaryFileTest, ContentsThatContradictThemselvesAreRefused) {
  const auto isRefused = [&](const BinaryWriter& content) {
    writeBinaryFile(file(), kFormat, content);
    return problemOf(readFile(file())) != "";
  };
  EXPECT_FALSE(isRefused(written(sample())));
  EXPECT_TRUE(isRefused(written(sample()).integer(0)));
  Sample outside = sample();
  outside.integer = 6;
  EXPECT_TRUE(isRefused(written(outside)));
  for (const std::int64_t count :
       {std::int64_t(-1), std::int64_t(1) << 40, std::numeric_limits<std::int64_t>::max()}) {
    EXPECT_TRUE(isRefused(BinaryWriter().integer(0).number(0).integer(count))) << count;
  }
}

TEST(Digest, TellsApart) {
  // The published values of FNV-1a.
  EXPECT_EQ(digestOf(""), "cbf29ce484222325");
  EXPECT_EQ(digestOf("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(digestOf("foobar"), "85944171f73967e8");
}

}  // namespace
}  // namespace morphgrid
