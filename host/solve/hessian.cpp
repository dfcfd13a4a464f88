#include "solve/hessian.h"

#include "solve/frame_hessian.h"
#include "solve/grid_hessian.h"

namespace morphgrid {

Hessian::Hessian(const Device& device, const DeviceGrid& grid, double smoothingWeight)
    : positions_(
          device, grid.positions().bytes(),
          BufferUsage::storageTexelBuffer | BufferUsage::transferSrc | BufferUsage::transferDst,
          MemoryKind::device),
      positionsView_(integerTexels(device, positions_)),
      smoothingWeight_(smoothingWeight) {}

std::unique_ptr<Hessian> makeHessian(const Device& device, const DeviceGrid& grid) {
  if (grid.isFrame()) {
    return std::make_unique<FrameHessian>(device, grid);
  }
  return std::make_unique<GridHessian>(device, grid, layerLoopFor(grid.shape()));
}

}  // namespace morphgrid
