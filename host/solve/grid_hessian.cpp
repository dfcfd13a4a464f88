#include "solve/grid_hessian.h"

#include "shared/hessian_types.h"
#include "solve/exact_product_comp.h"
#include "solve/hessian_blocks_comp.h"
#include "solve/hessian_first_smoothing_comp.h"
#include "solve/hessian_product_comp.h"
#include "solve/hessian_residual_comp.h"
#include "solve/hessian_smoothing_comp.h"

namespace morphgrid {

GridHessian::GridHessian(const Device& device, const DeviceGrid& grid, LayerLoop loop)
    : Hessian(device, grid, 2.0 / grid.mostVertices()),
      device_(device),
      shape_(grid.shape()),
      walk_(device, grid, kHessianBlockV, loop),
      texels_(device, grid),
      inverseDiagonal_(device, shape_.vertexCount()),
      inverseOffDiagonal_(device, shape_.vertexCount()),
      products_(device, hessian_product_comp_spirv, sizeof(HessianPush), walk_.constants()),
      exactProducts_(device, exact_product_comp_spirv, sizeof(HessianPush), walk_.constants()),
      residuals_(device, hessian_residual_comp_spirv, sizeof(HessianPush), walk_.constants()),
      smoothings_(device, hessian_smoothing_comp_spirv, sizeof(HessianPush), {}),
      firstSmoothings_(device, hessian_first_smoothing_comp_spirv, sizeof(HessianPush), {}),
      blocks_(device, hessian_blocks_comp_spirv, resourcesOfBlocks(), sizeof(HessianPush),
              walk_.constants()) {}

std::vector<KernelResource> GridHessian::resourcesOfBlocks() const {
  std::vector<KernelResource> resources{
      {kBindingPositions, &positionsView()},
      {kBindingInverseDiagonal, &inverseDiagonal_.buffer()},
      {kBindingInverseOffDiagonal, &inverseOffDiagonal_.buffer()}};
  texels_.appendTo(resources);
  return resources;
}

Hessian::Step GridHessian::columnStep(KernelFamily& kernels, const VertexVector& z,
                                      const VertexVector& result,
                                      std::vector<KernelResource> others) {
  texels_.appendTo(others);
  others.insert(others.end(), {{kBindingPositions, &positionsView()},
                               {kBindingVector, &z.texels()},
                               {kBindingResult, &result.buffer()}});
  return {kernels.bind(others), Step::Dispatch::columns};
}

Hessian::Step GridHessian::product(const VertexVector& z, const VertexVector& y) {
  return columnStep(products_, z, y, {});
}

Hessian::Step GridHessian::exactProduct(const VertexVector& z, const VertexVector& y) {
  return columnStep(exactProducts_, z, y, {});
}

Hessian::Step GridHessian::residual(const VertexVector& z, const VertexVector& b,
                                    const VertexVector& r) {
  return columnStep(residuals_, z, r, {{kBindingRightSide, &b.texels()}});
}

Hessian::Step GridHessian::smoothing(const VertexVector& z, const VertexVector& r,
                                     const VertexVector& next) {
  return {smoothings_.bind({{kBindingVector, &z.texels()},
                            {kBindingRightSide, &r.texels()},
                            {kBindingResult, &next.buffer()},
                            {kBindingInverseDiagonal, &inverseDiagonal_.texels()},
                            {kBindingInverseOffDiagonal, &inverseOffDiagonal_.texels()}}),
          Step::Dispatch::vertices};
}

Hessian::Step GridHessian::firstSmoothing(const VertexVector& b, const VertexVector& z) {
  return {firstSmoothings_.bind({{kBindingRightSide, &b.texels()},
                                 {kBindingResult, &z.buffer()},
                                 {kBindingInverseDiagonal, &inverseDiagonal_.texels()},
                                 {kBindingInverseOffDiagonal, &inverseOffDiagonal_.texels()}}),
          Step::Dispatch::vertices};
}

HessianPush GridHessian::push() const { return {walk_.push(), damping(), smoothingWeight()}; }

void GridHessian::recordLinearisation(CommandStream& stream, const Buffer& positions) const {
  stream.copy(positions, this->positions(), positions.bytes());
  stream.dispatch(blocks_, push(), groupsFor(shape_.verticesU, device_.subgroupSize()),
                  static_cast<std::uint32_t>(shape_.verticesV),
                  static_cast<std::uint32_t>(shape_.layers));
}

void GridHessian::record(CommandStream& stream, const Step& step) const {
  if (step.dispatch == Step::Dispatch::columns) {
    stream.dispatch(step.kernel, push(), walk_.groupsU(), walk_.groupsV());
  } else {
    stream.dispatch(step.kernel, push(), groupsFor(shape_.layerVertexCount(), kVertexInvocations),
                    static_cast<std::uint32_t>(shape_.layers));
  }
}

}  // namespace morphgrid
