#include "solve/frame_kernels.h"

#include "solve/column_walk.h"

namespace morphgrid {

FramePush framePushOf(const DeviceGrid& grid) {
  const DeviceFrame& frame = grid.frame();
  return {.grid = gridPushOf(grid),
          .lateral = frame.lateral,
          .upright = frame.upright,
          .lateralJoint = frame.lateralJoint,
          .uprightJoint = frame.uprightJoint,
          .damping = 0,
          .weight = 0,
          .centreLayer = grid.shape().layers / 2,
          .firstRow = 0};
}

FrameColumns::FrameColumns(const Device& device, const DeviceGrid& grid)
    : grid_(grid),
      subgroupSize_(device.subgroupSize()),
      rest_(integerTexels(device, grid.rest())),
      printed_(floatTexels(device, grid.printed())) {}

void FrameColumns::appendResources(std::vector<KernelResource>& resources) const {
  resources.push_back({kBindingRest, &rest_});
  resources.push_back({kBindingPrinted, &printed_});
}

std::uint32_t FrameColumns::groupsU() const {
  return groupsFor(grid_.shape().verticesU, subgroupSize_);
}

}  // namespace morphgrid
