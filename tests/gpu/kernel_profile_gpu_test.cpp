#include "gpu/kernel_profile.h"

#include <gtest/gtest.h>

#include "gpu/command_stream.h"

namespace morphgrid {
namespace {

constexpr int kCopies = 600;  // More than fit into one pool of queries.

Buffer buffer(const Device& device, std::uint64_t bytes) {
  using Usage = BufferUsage;
  return {device, bytes, Usage::transferSrc | Usage::transferDst, MemoryKind::device};
}

TEST(KernelProfile, TimesEveryCallOfEverySubmission) {
  const Device device({.selection = "", .validation = true, .profile = true});
  ASSERT_NE(device.profile(), nullptr);
  const Buffer from = buffer(device, 1 << 16);
  const Buffer to = buffer(device, 1 << 16);
  CommandStream stream(device);
  for (const int submissions : {1, 2}) {
    device.profile()->clear();
    stream.begin();
    for (int n = 0; n < kCopies; ++n) {
      stream.copy(from, to, from.bytes());
    }
    stream.end();
    for (int n = 0; n < submissions; ++n) {
      stream.submitAndWait();
    }
    const KernelProfile& profile = *device.profile();
    ASSERT_EQ(profile.kernels().size(), 1U);
    const KernelProfile::Share& copies = profile.kernels().at("copy");
    EXPECT_EQ(copies.calls, submissions * kCopies);
    EXPECT_EQ(profile.submissions().calls, submissions);
    EXPECT_GT(copies.seconds, 0);
    EXPECT_LT(copies.seconds, profile.submissions().seconds);
  }
  EXPECT_TRUE(device.validationMessages().empty());
}

TEST(KernelProfile, IsNotKeptUnlessAskedFor) { EXPECT_EQ(Device().profile(), nullptr); }

}  // namespace
}  // namespace morphgrid
