#include "solve/point_transfer.h"

namespace morphgrid {
namespace {

std::vector<KernelResource> productResources(const PointLevel& fine, const PointLevel& coarse,
                                             const TexelBuffer& levers) {
  std::vector<KernelResource> resources = fine.matrixTexels();
  const std::vector<KernelResource> written = coarse.matrixBuffers();
  resources.insert(resources.end(), written.begin(), written.end());
  resources.push_back({kBindingCoarseCentres, &coarse.centres().texels()});
  resources.push_back({kBindingLevers, &levers.texels()});
  return resources;
}

}  // namespace

PointGrid coarsened(PointGrid points) { return {points.u / 2 + 1, points.v / 2 + 1}; }

PointTransfer::PointTransfer(const Device& device, PointKernels& kernels, const PointLevel& fine,
                             const PointLevel& coarse, double resolution)
    : device_(device),
      fine_(fine),
      coarse_(coarse),
      resolution_(resolution),
      levers_(device, static_cast<std::size_t>(fine.points().count()), TexelFormat::int4,
              MemoryKind::device),
      centresKernel_(kernels.levers.bind({{kBindingCentres, &fine.centres().texels()},
                                          {kBindingCoarseCentres, &coarse.centres().buffer()},
                                          {kBindingLevers, &levers_.buffer()}})),
      product_(device, kernels.product, coarse.points(), productResources(fine, coarse, levers_)),
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

TransferPush PointTransfer::push() const {
  return {sizeOf(fine_.points()), sizeOf(coarse_.points()), static_cast<float>(resolution_), 0};
}

void PointTransfer::recordCentres(CommandStream& stream) const {
  dispatchPoints(device_, stream, centresKernel_, push(), fine_.points());
}

void PointTransfer::recordProduct(CommandStream& stream) const { product_.record(stream, push()); }

void PointTransfer::recordRestriction(CommandStream& stream) const {
  restriction_.record(stream, push());
}

void PointTransfer::recordProlongation(CommandStream& stream) const {
  prolongation_.record(stream, push());
}

}  // namespace morphgrid
