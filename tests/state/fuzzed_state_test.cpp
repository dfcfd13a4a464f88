#include <gtest/gtest.h>

#include <random>

#include "core/read_file.h"
#include "tests/fuzz/read_fuzzed_state.h"
#include "tests/state/sample_state.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

/// A state as readFuzzedState() takes it.
std::string sampleInput() {
  const TemporaryFolder folder;
  writeState(folder / kStateFile, sampleState());
  std::string bytes = readFile(folder / kStateFile);
  const auto length =
      static_cast<unsigned char>(bytes[0]) + 256u * static_cast<unsigned char>(bytes[1]);
  bytes.insert(8 + length, "\n");
  return bytes.substr(8, bytes.size() - 8 - sizeof(std::uint32_t));
}

TEST(FuzzedState, GetsPastLengthAndChecksum) {
  const TemporaryFolder folder;
  const auto file = folder.write(kStateFile, framedState(sampleInput()));
  EXPECT_EQ(readState(file).record.title, "Sample");
}

TEST(FuzzedState, WrongBytesBehindARightChecksumAreRefusedOrMakeSense) {
  const std::string input = sampleInput();
  std::mt19937 random(1);
  for (int n = 0; n < 4000; ++n) {
    std::string changed = input;
    // Single bits, bytes of numbers in the header, all ones: not a number where doubles stand.
    const std::size_t at = random() % changed.size();
    switch (random() % 4) {
      case 0:
        changed[at] = static_cast<char>(changed[at] ^ (1 << random() % 8));
        break;
      case 1:
        changed[at] = static_cast<char>('0' + random() % 10);
        break;
      case 2:
        changed.replace(at, 8, "\xff\xff\xff\xff\xff\xff\xff\xff");
        break;
      default:
        changed.erase(at, 1 + random() % 64);
    }
    ASSERT_NO_THROW(readFuzzedState(changed)) << n;
  }
}

}  // namespace
}  // namespace morphgrid
