#pragma once
#include "solve/frame_kernels.h"
#include "solve/hessian.h"
#include "solve/kernel_family.h"
#include "solve/point_level.h"

namespace morphgrid {

/// That of a frame of welded bars: `sum of stiffness J^T J`, J the derivatives of a bar's six
/// strains (shaders/energy/beam.glsl), and what tension adds against motions across the bar.
class FrameHessian : public Hessian {
 public:
  /// Keeps references. Throws DeviceError when the grid exceeds the device's limits.
  FrameHessian(const Device& device, const DeviceGrid& grid);

  Step product(const VertexVector& z, const VertexVector& y) override;
  Step exactProduct(const VertexVector& z, const VertexVector& y) override;
  Step residual(const VertexVector& z, const VertexVector& b, const VertexVector& r) override;
  Step smoothing(const VertexVector& z, const VertexVector& r, const VertexVector& next) override;
  Step firstSmoothing(const VertexVector& b, const VertexVector& z) override;

  void recordLinearisation(CommandStream& stream, const Buffer& positions) const override;
  void record(CommandStream& stream, const Step& step) const override;

 private:
  FramePush push() const;
  KernelFamily family(ShaderCode spirv) const;
  Step columnStep(KernelFamily& kernels, const VertexVector& z, const VertexVector& result,
                  std::vector<KernelResource> others);
  Step vertexStep(KernelFamily& kernels, const VertexVector& result,
                  std::vector<KernelResource> others);
  std::vector<KernelResource> blockResources() const;

  const Device& device_;
  GridShape shape_;
  FrameColumns columns_;
  BlockField inverse_;
  KernelFamily products_;
  KernelFamily exactProducts_;
  KernelFamily residuals_;
  KernelFamily smoothings_;
  KernelFamily firstSmoothings_;
  ComputeKernel blocks_;
};

}  // namespace morphgrid
