#pragma once
#include <vector>

#include "gpu/compute_kernel.h"
#include "shared/frame_types.h"
#include "solve/device_grid.h"

namespace morphgrid {

/// What the kernels of a frame get told; damping, weight and firstRow are 0.
FramePush framePushOf(const DeviceGrid& grid);

/// Views of what does not change while a frame is solved, and how its kernels are dispatched: an
/// invocation a column.
class FrameColumns {
 public:
  /// Keeps a reference to the grid, which is a frame.
  FrameColumns(const Device& device, const DeviceGrid& grid);

  FramePush push() const { return framePushOf(grid_); }
  /// Rest lengths, printed directions and loads.
  void appendResources(std::vector<KernelResource>& resources) const;
  std::vector<std::uint32_t> constants() const;

  std::uint32_t groupsU() const;
  std::uint32_t groupsV() const { return static_cast<std::uint32_t>(grid_.shape().verticesV); }
  std::uint32_t groupCount() const { return groupsU() * groupsV(); }

 private:
  const DeviceGrid& grid_;
  std::uint32_t subgroupSize_;
  TexelView rest_;
  TexelView printed_;
  TexelView loads_;  ///< Of frames without loads these two are others, which no kernel reads.
  TexelView printedPositions_;
};

}  // namespace morphgrid
