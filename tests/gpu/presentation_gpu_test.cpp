#include <gmock/gmock.h>

#include "core/error.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Presentation, ADeviceThatCannotDrawIntoWindowsIsRefusedWithAWayOut) {
  DeviceOptions options = sharedDeviceOptions();
  options.presentation->isSupported = [](VkInstance, VkPhysicalDevice, std::uint32_t) {
    return false;
  };
  EXPECT_THAT([&] { Device{options}; },
              ThrowsMessage<DeviceError>(
                  AllOf(HasSubstr("cannot draw into a window"), HasSubstr("`morphgrid run`"))));
}

}  // namespace
}  // namespace morphgrid
