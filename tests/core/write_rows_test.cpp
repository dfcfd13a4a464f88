#include "core/write_rows.h"

#include <gtest/gtest.h>

#include <sstream>

namespace morphgrid {
namespace {

class WriteRows : public testing::TestWithParam<std::ptrdiff_t> {};
INSTANTIATE_TEST_SUITE_P(Counts, WriteRows, testing::Values(0, 1, 4097, 300000));

TEST_P(WriteRows, RowsStandInTheirOrder) {
  std::ostringstream stream;
  writeRows(stream, GetParam(),
            [](std::string& bytes, std::ptrdiff_t row) { bytes += std::to_string(row) + "\n"; });
  std::istringstream text(stream.str());
  std::ptrdiff_t expected = 0;
  for (std::string line; std::getline(text, line); ++expected) {
    ASSERT_EQ(line, std::to_string(expected));
  }
  EXPECT_EQ(expected, GetParam());
}

}  // namespace
}  // namespace morphgrid
