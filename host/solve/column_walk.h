#pragma once
#include <cstdint>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/compute_kernel.h"
#include "shared/solver_types.h"
#include "solve/device_grid.h"

namespace morphgrid {

/// Whether a kernel's loop over the layers is unrolled, where they are few: it runs twice as fast,
/// takes twice as long to compile, and serves no other number of layers.
enum class LayerLoop { unrolled, rolled };

/// The choice that takes less time for a kernel that runs a few hundred times, compiling included.
LayerLoop layerLoopFor(const GridShape& shape);

/// What the kernels of a grid get told.
GridPush gridPushOf(const DeviceGrid& grid);

/// How kernels that include shaders/solve/columns.glsl are specialised and dispatched for a grid.
class ColumnWalk {
 public:
  /// blockV: rows of columns per invocation, kBlockV of the kernel; kBlockU is kSweepBlockU.
  /// Keeps a reference to the grid.
  ColumnWalk(const Device& device, const DeviceGrid& grid, std::uint32_t blockV,
             LayerLoop loop = LayerLoop::unrolled);

  /// Specialisation constants in the order of their numbers, kConstantLayers and so on. measures:
  /// the kernel sums up energy and residual, as only sweeps may.
  std::vector<std::uint32_t> constants(bool measures = false) const;
  GridPush push() const { return gridPushOf(grid_); }

  std::uint32_t groupsU() const { return groupsU_; }
  std::uint32_t groupsV() const { return groupsV_; }
  std::uint32_t groupCount() const { return groupsU_ * groupsV_; }

 private:
  const DeviceGrid& grid_;
  LayerLoop loop_;
  std::uint32_t subgroupSize_;
  std::uint32_t groupsU_;
  std::uint32_t groupsV_;
};

/// Workgroups of groupSize invocations that cover `count`.
std::uint32_t groupsFor(int count, std::uint32_t groupSize);

/// Four 32-bit components a texel, to be read by imageLoad.
TexelView integerTexels(const Device& device, const Buffer& buffer);
TexelView floatTexels(const Device& device, const Buffer& buffer);

/// Views of what does not change while a grid is solved.
class GridTexels {
 public:
  GridTexels(const Device& device, const DeviceGrid& grid);

  void appendTo(std::vector<KernelResource>& resources) const;

 private:
  TexelView rest_;
  TexelView stiffness_;
  TexelView printed_;
};

}  // namespace morphgrid
