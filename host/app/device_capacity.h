#pragma once
#include <optional>
#include <string>

#include "app/scene.h"
#include "gpu/available_memory.h"

namespace morphgrid {

/// What a device leaves a solve to work with.
struct DeviceCapacity {
  std::string deviceName;
  AvailableMemory memory;
  std::uint64_t largestBuffer;  ///< Bytes.
  std::uint64_t mostBound;      ///< Bytes of one that a kernel can write.
  std::uint64_t mostVertices;   ///< That one dispatch can visit; in a row, and so many rows:
  std::uint64_t mostVerticesU;
  std::uint64_t mostVerticesV;
};

DeviceCapacity capacityOf(const Device& device);

/// What is to be done with a grid.
struct Workload {
  Method method;
  bool inverseDesign = false;  ///< After the solve.
  Mechanics mechanics = Mechanics::springs;
};

Workload workloadOf(const Scene& scene);

/// Why that cannot be done there, and the largest grid of the same proportions for which it can;
/// nothing when it can, or for Method::reference, which needs no device.
std::optional<std::string> explainOverflow(const GridShape& shape, const Workload& work,
                                           const DeviceCapacity& capacity);

}  // namespace morphgrid
