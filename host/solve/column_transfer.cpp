#include "solve/column_transfer.h"

#include "solve/column_matrix_comp.h"
#include "solve/prolong_columns_comp.h"
#include "solve/restrict_columns_comp.h"

namespace morphgrid {
namespace {

int centreLayer(const GridShape& shape) { return shape.layers / 2; }

std::vector<KernelResource> matrixResources(const PointLevel& columns, const GridTexels& grid) {
  std::vector<KernelResource> resources = columns.matrixBuffers();
  resources.push_back({kBindingRest, &grid.rest});
  resources.push_back({kBindingStiffness, &grid.stiffness});
  return resources;
}

}  // namespace

ColumnTransfer::ColumnTransfer(const Device& device, const DeviceGrid& grid,
                               const PointLevel& columns, const Buffer& positions,
                               const Buffer& residual, const Buffer& correction)
    : device_(device),
      grid_(grid),
      columns_(columns),
      positions_(positions),
      positionTexels_(integerTexels(device, positions)),
      residualTexels_(floatTexels(device, residual)),
      correctionTexels_(floatTexels(device, correction)),
      gridTexels_(device, grid),
      matrix_(kernel(column_matrix_comp_spirv, matrixResources(columns, gridTexels_))),
      restriction_(
          kernel(restrict_columns_comp_spirv, {{kBindingFineVector, &residualTexels_},
                                               {kBindingResult, &columns.rightSide().buffer()}})),
      prolongation_(family(prolong_columns_comp_spirv)
                        .bind({{kBindingPositions, &positionTexels_},
                               {kBindingCoarseVector, &columns.result().texels()},
                               {kBindingFineVector, &correctionTexels_},
                               {kBindingFineResult, &correction}})) {}

KernelFamily ColumnTransfer::family(ShaderCode spirv) const {
  return {device_, spirv, sizeof(ColumnPush), {device_.subgroupSize()}};
}

PointKernel ColumnTransfer::kernel(ShaderCode spirv, std::vector<KernelResource> resources) const {
  resources.push_back({kBindingPositions, &positionTexels_});
  KernelFamily kernels = family(spirv);
  return {device_, kernels, columns_.points(), resources};
}

ColumnPush ColumnTransfer::push(double damping) const {
  return {gridPushOf(grid_), centreLayer(grid_.shape()), static_cast<float>(damping), 0};
}

void ColumnTransfer::recordCentres(CommandStream& stream) const {
  const std::uint64_t bytes = columns_.centres().buffer().bytes();
  stream.copy(positions_, columns_.centres().buffer(), bytes,
              static_cast<std::uint64_t>(centreLayer(grid_.shape())) * bytes);
}

void ColumnTransfer::recordMatrix(CommandStream& stream, double damping) const {
  matrix_.record(stream, push(damping));
}

void ColumnTransfer::recordRestriction(CommandStream& stream) const {
  restriction_.record(stream, push(0));
}

void ColumnTransfer::recordProlongation(CommandStream& stream) const {
  dispatchPoints(device_, stream, prolongation_, push(0), columns_.points());
}

}  // namespace morphgrid
