#include "gpu/device_failure.h"

#include <vulkan/vulkan.hpp>

namespace morphgrid {

bool isDeviceFailure(const std::system_error& error) {
  return error.code().category() == vk::errorCategory();
}

}  // namespace morphgrid
