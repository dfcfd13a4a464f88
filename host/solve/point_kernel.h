#pragma once
#include "gpu/command_stream.h"
#include "shared/topology.h"
#include "solve/kernel_family.h"

namespace morphgrid {

/// How many points a coarse level of multigrid has; in a row of the grid, and rows.
struct PointGrid {
  int u;
  int v;

  int count() const { return u * v; }
  bool operator==(const PointGrid&) const = default;
};

/// The size as the functions of shared/topology.h take it.
inline ivec2 sizeOf(PointGrid points) { return {points.u, points.v}; }

/// Chunks begin at every so many rows: with 16 bytes a point or a multiple, any device binds there.
constexpr int kChunkRows = 16;

/// A kernel that computes something for every point and writes it to storage buffers of as many
/// bytes a point: in chunks of rows, so that no chunk writes more of a buffer than the device can
/// bind. Reads go through texels, which see all of a buffer.
class PointKernel {
 public:
  /// Throws DeviceError when the device's limits are exceeded all the same.
  PointKernel(const Device& device, KernelFamily& family, PointGrid points,
              const std::vector<KernelResource>& resources);

  /// Push::firstRow is set for each chunk.
  template <typename Push>
  void record(CommandStream& stream, Push push) const {
    for (const Chunk& chunk : chunks_) {
      push.firstRow = chunk.firstRow;
      stream.dispatch(chunk.kernel, push, groupsU_, static_cast<std::uint32_t>(chunk.rows));
    }
  }

 private:
  struct Chunk {
    int firstRow;
    int rows;
    ComputeKernel kernel;
  };

  std::uint32_t groupsU_;
  std::vector<Chunk> chunks_;
};

/// Dispatches one invocation a point, or a column.
template <typename Push>
void dispatchPoints(const Device& device, CommandStream& stream, const ComputeKernel& kernel,
                    const Push& push, PointGrid points) {
  const std::uint32_t width = device.subgroupSize();
  stream.dispatch(kernel, push, (static_cast<std::uint32_t>(points.u) + width - 1) / width,
                  static_cast<std::uint32_t>(points.v));
}

}  // namespace morphgrid
