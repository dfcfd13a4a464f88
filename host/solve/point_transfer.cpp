#include "solve/point_transfer.h"

namespace morphgrid {
PointGrid coarsened(PointGrid points) { return {points.u / 2 + 1, points.v / 2 + 1}; }

PointTransfer::PointTransfer(const Device& device, PointKernels& kernels, const PointLevel& fine,
                             const PointLevel& coarse, const DeviceGrid& grid)
    : device_(device),
      grid_(grid),
      fine_(fine),
      coarse_(coarse),
      levers_(device, static_cast<std::size_t>(fine.points().count()), TexelFormat::int4,
              MemoryKind::device),
      centresKernel_(kernels.levers.bind({{kBindingCentres, &fine.centres().texels()},
                                          {kBindingCoarseCentres, &coarse.centres().buffer()},
                                          {kBindingLevers, &levers_.buffer()}})),
      products_(productKernels(kernels)),
      restriction_(device, kernels.restriction, coarse.points(),
                   {{kBindingFineVector, &fine.result().texels()},
                    {kBindingCoarseCentres, &coarse.centres().texels()},
                    {kBindingLevers, &levers_.texels()},
                    {kBindingResult, &coarse.rightSide().buffer()}}),
      prolongation_(device, kernels.prolongation, fine.points(),
                    {{kBindingCoarseVector, &coarse.result().texels()},
                     {kBindingCoarseCentres, &coarse.centres().texels()},
                     {kBindingLevers, &levers_.texels()},
                     {kBindingFineVector, &fine.iterate().texels()},
                     {kBindingFineResult, &fine.iterate().buffer()}}) {}

std::vector<PointKernel> PointTransfer::productKernels(PointKernels& kernels) const {
  std::vector<KernelResource> common = fine_.matrixTexels();
  common.push_back({kBindingCoarseCentres, &coarse_.centres().texels()});
  common.push_back({kBindingLevers, &levers_.texels()});
  std::vector<PointKernel> products;
  for (std::uint32_t n = 0; n < kStencilSize; ++n) {
    std::vector<KernelResource> resources = common;
    coarse_.blocks(n).appendBuffers(resources, kBindingCoarseMatrix);
    products.emplace_back(device_, kernels.product, coarse_.points(), resources);
  }
  return products;
}

TransferPush PointTransfer::push() const {
  TransferPush push{};
  push.fineSize = sizeOf(fine_.points());
  push.coarseSize = sizeOf(coarse_.points());
  push.resolution = static_cast<float>(grid_.resolution());
  push.shearSquared = static_cast<float>(grid_.shearSquared());
  return push;
}

void PointTransfer::recordCentres(CommandStream& stream) const {
  dispatchPoints(device_, stream, centresKernel_, push(), fine_.points());
}

void PointTransfer::recordProduct(CommandStream& stream) const {
  TransferPush push = this->push();
  for (std::uint32_t n = 0; n < kStencilSize; ++n) {
    push.direction = stencilOffset(n);
    products_[n].record(stream, push);
  }
}

void PointTransfer::recordRestriction(CommandStream& stream) const {
  restriction_.record(stream, push());
}

void PointTransfer::recordProlongation(CommandStream& stream) const {
  prolongation_.record(stream, push());
}

}  // namespace morphgrid
