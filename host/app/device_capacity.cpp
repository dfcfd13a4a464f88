#include "app/device_capacity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/lbfgs_types.h"
#include "shared/solver_types.h"
#include "solve/solve_memory.h"

namespace morphgrid {
namespace {

SolveMemory memoryFor(const GridShape& shape, const Workload& work) {
  if (work.inverseDesign) {
    return inverseDesignMemory(shape, work.mechanics);
  }
  return work.method == Method::jacobi ? jacobiMemory(shape)
                                       : multigridMemory(shape, work.mechanics);
}

double vertexCount(const GridShape& shape) {
  return double(shape.verticesU) * shape.verticesV * shape.layers;
}

std::string gigabytes(std::uint64_t bytes) { return fmt::format("{:.3g} GB", bytes / 1e9); }

/// "" when nothing is.
std::string describeShortfall(const GridShape& shape, const Workload& work,
                              const DeviceCapacity& capacity) {
  const SolveMemory needed = memoryFor(shape, work);
  const AvailableMemory& available = capacity.memory;
  if (available.shared && needed.device + needed.host > available.host) {
    return fmt::format("{} of memory, {} are free", gigabytes(needed.device + needed.host),
                       gigabytes(available.host));
  }
  if (needed.device > available.device) {
    return fmt::format("{} of memory on {}, {} are free there", gigabytes(needed.device),
                       capacity.deviceName, gigabytes(available.device));
  }
  if (needed.host > available.host) {
    return fmt::format("{} of memory, {} are free", gigabytes(needed.host),
                       gigabytes(available.host));
  }
  if (needed.largestBuffer > capacity.largestBuffer) {
    return fmt::format("a buffer of {}, {} has them of {} at most", gigabytes(needed.largestBuffer),
                       capacity.deviceName, gigabytes(capacity.largestBuffer));
  }
  if (needed.mostBound > capacity.mostBound) {
    return fmt::format("{} of one buffer at a time, {} reaches {} at most",
                       gigabytes(needed.mostBound), capacity.deviceName,
                       gigabytes(capacity.mostBound));
  }
  if (vertexCount(shape) > double(capacity.mostVertices)) {
    return fmt::format("more than the {} invocations that {} can be asked for at once",
                       capacity.mostVertices, capacity.deviceName);
  }
  if (static_cast<std::uint64_t>(shape.verticesU) > capacity.mostVerticesU ||
      static_cast<std::uint64_t>(shape.verticesV) > capacity.mostVerticesV) {
    return fmt::format("more than the {} x {} vertices a layer that {} can be asked for at once",
                       capacity.mostVerticesU, capacity.mostVerticesV, capacity.deviceName);
  }
  return "";
}

/// The same proportions with so many nodes along the longer edge.
GridShape scaled(const GridShape& shape, int nodesLong) {
  const int nodesU = shape.verticesU - 1;
  const int nodesV = shape.verticesV - 1;
  const double factor = double(nodesLong) / std::max(nodesU, nodesV);
  const auto vertices = [&](int nodes) {
    return std::max(1, static_cast<int>(std::lround(factor * nodes))) + 1;
  };
  return {vertices(nodesU), vertices(nodesV), shape.layers};
}

GridShape largestThatFits(const GridShape& shape, const Workload& work,
                          const DeviceCapacity& capacity) {
  int fits = 1;
  int tooMany = std::max(shape.verticesU, shape.verticesV) - 1;
  while (tooMany - fits > 1) {
    const int middle = fits + (tooMany - fits) / 2;
    (describeShortfall(scaled(shape, middle), work, capacity).empty() ? fits : tooMany) = middle;
  }
  return scaled(shape, fits);
}

}  // namespace

DeviceCapacity capacityOf(const Device& device) {
  const DeviceLimits& limits = device.limits();
  const std::uint64_t largestBuffer = std::min(
      std::uint64_t{limits.maxTexelBufferElements} * sizeof(vec4), limits.maxMemoryAllocationSize);
  return {device.name(),
          availableMemory(device),
          largestBuffer,
          limits.maxStorageBufferRange,
          std::uint64_t{limits.maxComputeWorkGroupCount[0]} * kVectorInvocations,
          std::uint64_t{limits.maxComputeWorkGroupCount[0]} * device.subgroupSize(),
          limits.maxComputeWorkGroupCount[1]};
}

Workload workloadOf(const Scene& scene) {
  const DesignRequest& design = scene.design;
  return {scene.method,
          scene.method == Method::multigrid &&
              (design.compensateRounds + design.optimiseSteps > 0 || design.enforceShrinkage),
          mechanicsOf(scene.material.model)};
}

std::optional<std::string> explainOverflow(const GridShape& shape, const Workload& work,
                                           const DeviceCapacity& capacity) {
  if (work.method == Method::reference) {
    return std::nullopt;
  }
  const std::string shortfall = describeShortfall(shape, work, capacity);
  if (shortfall.empty()) {
    return std::nullopt;
  }
  const GridShape largest = largestThatFits(shape, work, capacity);
  return fmt::format(
      "a grid of {} x {} nodes in {} layers ({:.0f} vertices) needs {}; {} x {} nodes ({:.0f} "
      "vertices) would fit: set {} along the longer edge",
      shape.verticesU - 1, shape.verticesV - 1, shape.layers, vertexCount(shape), shortfall,
      largest.verticesU - 1, largest.verticesV - 1, vertexCount(largest),
      std::max(largest.verticesU, largest.verticesV) - 1);
}

}  // namespace morphgrid
