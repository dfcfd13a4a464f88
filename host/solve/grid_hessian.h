#pragma once
#include "shared/hessian_types.h"
#include "solve/column_walk.h"
#include "solve/hessian.h"
#include "solve/kernel_family.h"

namespace morphgrid {

/// That of struts and corners.
///
/// strut: `2 c (n n^T + max(0, 1 - L / l) (I - n n^T))`; corner: `2 w J^T J`, J the derivative of
/// `s sqrt(2 / (T + D))` (docs/method.md, Energy). The smoothing weight is the largest that can
/// amplify nothing: 2 by DeviceGrid::mostVertices(). With struts and corners that is 3; the largest
/// eigenvalue of D^-1 H is 2.0 to 2.1 at the usual weights, up to 2.7 where only corners count.
class GridHessian : public Hessian {
 public:
  /// Keeps references. Throws DeviceError when the grid exceeds the device's limits.
  GridHessian(const Device& device, const DeviceGrid& grid, LayerLoop loop = LayerLoop::unrolled);

  Step product(const VertexVector& z, const VertexVector& y) override;
  Step exactProduct(const VertexVector& z, const VertexVector& y) override;
  Step residual(const VertexVector& z, const VertexVector& b, const VertexVector& r) override;
  Step smoothing(const VertexVector& z, const VertexVector& r, const VertexVector& next) override;
  Step firstSmoothing(const VertexVector& b, const VertexVector& z) override;

  void recordLinearisation(CommandStream& stream, const Buffer& positions) const override;
  void record(CommandStream& stream, const Step& step) const override;

 private:
  HessianPush push() const;
  std::vector<KernelResource> resourcesOfBlocks() const;
  Step columnStep(KernelFamily& kernels, const VertexVector& z, const VertexVector& result,
                  std::vector<KernelResource> others);

  const Device& device_;
  GridShape shape_;
  ColumnWalk walk_;
  GridTexels texels_;
  VertexVector inverseDiagonal_;
  VertexVector inverseOffDiagonal_;
  KernelFamily products_;
  KernelFamily exactProducts_;
  KernelFamily residuals_;
  KernelFamily smoothings_;
  KernelFamily firstSmoothings_;
  ComputeKernel blocks_;
};

}  // namespace morphgrid
