#include "gpu/buffer.h"

#include "core/error.h"
#include "gpu/resource_set.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

constexpr std::uint64_t kBytes = 1 << 20;

Buffer storage(const Device& device, MemoryKind kind) {
  return {device, kBytes, BufferUsage::storageBuffer, kind};
}

TEST_F(DeviceTest, CountsTheMemoryOfItsBuffers) {
  MemoryUse& use = device_.memoryUse();
  ASSERT_EQ(use.current(), 0U);
  std::vector<Buffer> kept;
  kept.push_back(storage(device_, MemoryKind::device));
  const std::uint64_t one = use.current();
  EXPECT_GE(one, kBytes);
  EXPECT_LT(one, kBytes + (kBytes >> 4));
  {
    const Buffer second = storage(device_, MemoryKind::host);
    EXPECT_EQ(use.current(), 2 * one);
  }
  EXPECT_EQ(use.current(), one);
  EXPECT_EQ(use.peak(), 2 * one);
  use.forgetPeak();
  EXPECT_EQ(use.peak(), one);
  kept.push_back(storage(device_, MemoryKind::device));  // Moves the first.
  EXPECT_EQ(use.current(), 2 * one);
  kept.clear();
  EXPECT_EQ(use.current(), 0U);
  EXPECT_EQ(use.peak(), 2 * one);
}

TEST_F(DeviceTest, BindsAsMuchOfABufferAsShadersReach) {
  const Device device({.selection = "", .validation = true, .largestStorageBuffer = kBytes / 2});
  const Buffer buffer = storage(device, MemoryKind::device);
  const ResourceLayout layout(device, {{0, ResourceType::storageBuffer}}, ShaderStage::compute);
  const auto bind = [&](const BufferRange& range) { ResourceSet(device, layout, {{0, range}}); };
  EXPECT_NO_THROW(bind({&buffer, kBytes / 2, kBytes / 2}));
  EXPECT_THROW(bind({&buffer, 0, kBytes / 2 + 16}), DeviceError);
  EXPECT_THROW(bind(&buffer), DeviceError);
  EXPECT_TRUE(device.validationMessages().empty());
}

}  // namespace
}  // namespace morphgrid
