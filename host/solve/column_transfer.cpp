#include "solve/column_transfer.h"

#include "solve/column_matrix_comp.h"
#include "solve/frame_column_matrix_comp.h"
#include "solve/prolong_columns_comp.h"
#include "solve/restrict_columns_comp.h"

namespace morphgrid {
namespace {

int centreLayer(const GridShape& shape) { return shape.layers / 2; }

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
      frame_(grid.isFrame() ? std::optional<FrameColumns>(std::in_place, device, grid)
                            : std::nullopt),
      matrix_(matrixKernel()),
      restriction_(kernel(family(restrict_columns_comp_spirv),
                          {{kBindingFineVector, &residualTexels_},
                           {kBindingResult, &columns.rightSide().buffer()}})),
      prolongation_(family(prolong_columns_comp_spirv)
                        .bind({{kBindingPositions, &positionTexels_},
                               {kBindingCoarseVector, &columns.result().texels()},
                               {kBindingFineVector, &correctionTexels_},
                               {kBindingFineResult, &correction}})) {}

KernelFamily ColumnTransfer::family(ShaderCode spirv) const {
  std::vector<std::uint32_t> constants{device_.subgroupSize(), grid_.isFrame() ? 1U : 0U};
  static_assert(kConstantSubgroupSize == 0 && kConstantJointsTurn == 1);
  return {device_, spirv, sizeof(ColumnPush), std::move(constants)};
}

PointKernel ColumnTransfer::matrixKernel() const {
  std::vector<KernelResource> resources = columns_.matrixBuffers();
  if (frame_) {
    frame_->appendResources(resources);
    return kernel({device_, frame_column_matrix_comp_spirv, sizeof(FramePush), frame_->constants()},
                  std::move(resources));
  }
  gridTexels_.appendTo(resources);
  std::vector<std::uint32_t> constants(kColumnConstants);
  constants[kConstantSubgroupSize] = device_.subgroupSize();
  constants[kConstantPrintedCorners] = grid_.mechanics() == Mechanics::springsAsPrinted ? 1 : 0;
  return kernel({device_, column_matrix_comp_spirv, sizeof(ColumnPush), std::move(constants)},
                std::move(resources));
}

PointKernel ColumnTransfer::kernel(KernelFamily kernels,
                                   std::vector<KernelResource> resources) const {
  resources.push_back({kBindingPositions, &positionTexels_});
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
  if (frame_) {
    FramePush push = frame_->push();
    push.damping = static_cast<float>(damping);
    matrix_.record(stream, push);
  } else {
    matrix_.record(stream, push(damping));
  }
}

void ColumnTransfer::recordRestriction(CommandStream& stream) const {
  restriction_.record(stream, push(0));
}

void ColumnTransfer::recordProlongation(CommandStream& stream) const {
  dispatchPoints(device_, stream, prolongation_, push(0), columns_.points());
}

}  // namespace morphgrid
