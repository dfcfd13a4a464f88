#pragma once
#include <gtest/gtest.h>

#include "gpu/device.h"

namespace morphgrid {

/// Tests on the device with the validation layers on; any message fails the test.
class DeviceTest : public testing::Test {
 protected:
  void TearDown() override {
    for (const std::string& message : device_.validationMessages()) {
      ADD_FAILURE() << message;
    }
  }

  Device device_{DeviceOptions{.selection = "", .validation = true}};
};

/// With the validation layers, as for windows, but for none: what it does is cut into short pieces.
inline DeviceOptions sharedDeviceOptions() {
  DeviceOptions options{.selection = "", .validation = true};
  options.presentation = Presentation{
      {"VK_KHR_surface"}, [](VkInstance, VkPhysicalDevice, std::uint32_t) { return true; }};
  return options;
}

}  // namespace morphgrid
