#pragma once
#include <system_error>

namespace morphgrid {

/// Whether this is a call of Vulkan that failed where nobody made a DeviceError of it.
bool isDeviceFailure(const std::system_error& error);

}  // namespace morphgrid
