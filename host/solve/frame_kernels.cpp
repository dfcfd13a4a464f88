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
          .holding = frame.holding,
          .holdingAside = frame.holdingAside,
          .turning = frame.turning,
          .damping = 0,
          .weight = 0,
          .centreLayer = grid.shape().layers / 2,
          .firstRow = 0};
}

FrameColumns::FrameColumns(const Device& device, const DeviceGrid& grid)
    : grid_(grid),
      subgroupSize_(device.subgroupSize()),
      rest_(integerTexels(device, grid.rest())),
      printed_(floatTexels(device, grid.printed())),
      loads_(floatTexels(device, grid.isLoaded() ? grid.loads() : grid.printed())),
      printedPositions_(
          integerTexels(device, grid.isLoaded() ? grid.printedPositions() : grid.rest())) {}

void FrameColumns::appendResources(std::vector<KernelResource>& resources) const {
  resources.push_back({kBindingRest, &rest_});
  resources.push_back({kBindingPrinted, &printed_});
  resources.push_back({kBindingLoads, &loads_});
  resources.push_back({kBindingPrintedPositions, &printedPositions_});
}

std::vector<std::uint32_t> FrameColumns::constants() const {
  static_assert(kConstantSubgroupSize == 0 && kConstantIsLoaded == 1);
  return {subgroupSize_, grid_.isLoaded() ? 1U : 0U};
}

std::uint32_t FrameColumns::groupsU() const {
  return groupsFor(grid_.shape().verticesU, subgroupSize_);
}

}  // namespace morphgrid
