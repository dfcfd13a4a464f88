#pragma once
#include <functional>

#include "gpu/device.h"

namespace morphgrid {

/// tell: called once, when something waits for more than a second for kernels that the device's
/// driver compiles; may be empty.
void tellSlowCompile(const Device& device, std::function<void()> tell);

}  // namespace morphgrid
