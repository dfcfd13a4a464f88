#include "gpu/command_stream.h"

#include <gtest/gtest.h>

#include <numeric>

#include "gpu/submission_pace.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

TEST(CommandStream, CutIntoPartsDoesTheSame) {
  const Device device(sharedDeviceOptions());
  ASSERT_NE(device.pace(), nullptr);
  for (int n = 0; n < 50; ++n) {
    device.pace()->learn({{"copy", 1}}, 1, device.pace()->frameEvents());  // As dear as can be.
  }
  constexpr int kCount = 1 << 16;
  constexpr std::uint64_t kSize = kCount * sizeof(int);
  using Usage = BufferUsage;
  const Buffer a(device, kSize, Usage::transferSrc | Usage::transferDst, MemoryKind::device);
  const Buffer b(device, kSize, Usage::transferSrc | Usage::transferDst, MemoryKind::device);
  std::vector<int> numbers(kCount);
  std::iota(numbers.begin(), numbers.end(), 7);
  upload(device, a, numbers);

  // Each copy moves the numbers on by one place: all must run, in their order.
  constexpr int kCopies = 101;
  CommandStream stream(device);
  for (int run = 0; run < 2; ++run) {
    stream.begin();
    for (int n = 0; n < kCopies; ++n) {
      stream.copy(n % 2 == 0 ? a : b, n % 2 == 0 ? b : a, kSize - sizeof(int), sizeof(int));
    }
    stream.end();
  }
  stream.submitAndWait();

  EXPECT_EQ(download<int>(device, b, 1).front(), 7 + kCopies);
  EXPECT_TRUE(device.validationMessages().empty());
}

}  // namespace
}  // namespace morphgrid
