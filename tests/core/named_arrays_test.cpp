#include "core/named_arrays.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

constexpr ArrayFormat kSampleFormat{"morphgrid sample", 1, "sample", "make it again"};

class NamedArraysTest : public testing::Test {
 protected:
  NamedArraysTest() {
    ArrayList arrays;
    arrays.add("one", 2.5);
    arrays.add("points", {2, 3}, points_);
    arrays.addMade("odd", {2}, {std::nan(""), -1});
    writeArrayFile(path_, kSampleFormat, {}, arrays.all());
  }

  const TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_ / "sample.safetensors";
  const Eigen::Matrix3Xd points_ = Eigen::Matrix3Xd::Random(3, 2);
};

TEST_F(NamedArraysTest, ReadWhatWasWritten) {
  const ArrayFile file(path_, kSampleFormat);
  const ArrayReader reader(file);
  EXPECT_EQ(reader.number("one"), 2.5);
  EXPECT_EQ(reader.rowCount("points", 3), 2u);
  EXPECT_EQ(reader.points("points", {2, 3}), points_);
  EXPECT_TRUE(std::isnan(reader.bare("odd", {2})[0]));
  EXPECT_TRUE(reader.has("odd"));
  EXPECT_FALSE(reader.has("even"));
}

TEST_F(NamedArraysTest, RefuseWhatIsNotAsItMustBe) {
  const ArrayFile file(path_, kSampleFormat);
  const ArrayReader reader(file);
  EXPECT_THROW(reader.number("even"), InputError);
  EXPECT_THROW(reader.number("odd"), InputError);
  EXPECT_THROW(reader.numbers("odd", {2}), InputError);
  EXPECT_THROW(reader.numbers("one", {}, 2.5), InputError);
  EXPECT_NO_THROW(reader.numbers("one", {}, 2));
  EXPECT_THROW(reader.bare("odd", {2, 1}), InputError);
  EXPECT_THROW(reader.rowCount("points", 2), InputError);
  EXPECT_THROW(reader.points("points", {3, 2}), InputError);
}

TEST_F(NamedArraysTest, TakeOnlyIntegersWithinTheirBounds) {
  const ArrayFile file(path_, kSampleFormat);
  const ArrayReader reader(file);
  EXPECT_EQ(reader.integer(3, 0, 3), 3);
  EXPECT_EQ(reader.integer(kLargestExactInteger, 0, kLargestExactInteger), 1'000'000'000'000'000);
  for (const double value : {-1.0, 4.0, 2.5, std::nan("")}) {
    EXPECT_THROW(reader.integer(value, 0, 3), InputError) << value;
  }
}

}  // namespace
}  // namespace morphgrid
