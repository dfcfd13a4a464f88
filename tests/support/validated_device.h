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

}  // namespace morphgrid
