#pragma once
#include <cstdint>

#include "gpu/device.h"

namespace morphgrid {

/// How many bytes can still be had.
struct AvailableMemory {
  std::uint64_t device;
  std::uint64_t host;
  bool shared;  ///< The device is the host: both are the same bytes.
};

/// What the driver and the system say now; where the driver does not say how much is free, all of
/// its largest heap counts.
AvailableMemory availableMemory(const Device& device);

}  // namespace morphgrid
