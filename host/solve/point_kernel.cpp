#include "solve/point_kernel.h"

#include <algorithm>

namespace morphgrid {
namespace {

/// Bytes that a row takes in the written buffer that takes most.
std::uint64_t writtenBytesPerRow(const std::vector<KernelResource>& resources, PointGrid points) {
  std::uint64_t most = 0;
  for (const KernelResource& resource : resources) {
    if (const auto* range = std::get_if<BufferRange>(&resource.resource)) {
      most = std::max(most, range->bytes / static_cast<std::uint64_t>(points.v));
    }
  }
  return most;
}

/// At least kChunkRows, even where they are too many: then binding them tells so.
int rowsAtATime(const Device& device, PointGrid points, std::uint64_t bytesPerRow) {
  const std::uint64_t fitting = device.limits().maxStorageBufferRange / bytesPerRow;
  if (fitting >= static_cast<std::uint64_t>(points.v)) {
    return points.v;
  }
  return std::max(1, static_cast<int>(fitting) / kChunkRows) * kChunkRows;
}

/// With only those rows of what is written.
std::vector<KernelResource> resourcesOf(int firstRow, int rows, PointGrid points,
                                        std::vector<KernelResource> resources) {
  for (KernelResource& resource : resources) {
    if (auto* range = std::get_if<BufferRange>(&resource.resource)) {
      const std::uint64_t bytesPerRow = range->bytes / static_cast<std::uint64_t>(points.v);
      *range = {range->buffer, static_cast<std::uint64_t>(firstRow) * bytesPerRow,
                static_cast<std::uint64_t>(rows) * bytesPerRow};
    }
  }
  return resources;
}

}  // namespace

PointKernel::PointKernel(const Device& device, KernelFamily& family, PointGrid points,
                         const std::vector<KernelResource>& resources)
    : groupsU_((static_cast<std::uint32_t>(points.u) + device.subgroupSize() - 1) /
               device.subgroupSize()) {
  const int most = rowsAtATime(device, points, writtenBytesPerRow(resources, points));
  for (int row = 0; row < points.v; row += most) {
    const int rows = std::min(most, points.v - row);
    chunks_.push_back({row, rows, family.bind(resourcesOf(row, rows, points, resources))});
  }
}

}  // namespace morphgrid
