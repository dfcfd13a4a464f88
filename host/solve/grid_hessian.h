#pragma once
#include "gpu/command_stream.h"
#include "shared/hessian_types.h"
#include "solve/column_walk.h"
#include "solve/kernel_family.h"
#include "solve/vertex_vector.h"

namespace morphgrid {

/// The Gauss-Newton Hessian H of a grid's energy at a linearisation point, matrix-free, and a
/// block-Jacobi smoother for it: the finest level of multigrid. Positive semidefinite. Lengths in
/// units of the spacing, energies in stiffness x spacing^2.
///
/// strut: `2 c (n n^T + max(0, 1 - L / l) (I - n n^T))`; corner: `2 w J^T J`, J the derivative of
/// `s sqrt(2 / (T + D))` (docs/method.md, Energy).
class GridHessian {
 public:
  /// One of the operations below, bound to its vectors, to be recorded as often as wanted. They
  /// must outlive it.
  class Step {
   private:
    friend GridHessian;
    enum class Dispatch { columns, vertices };
    Step(ComputeKernel kernel, Dispatch dispatch)
        : kernel_(std::move(kernel)), dispatch_(dispatch) {}
    ComputeKernel kernel_;
    Dispatch dispatch_;
  };

  /// Keeps references. Throws DeviceError when the grid exceeds the device's limits.
  GridHessian(const Device& device, const DeviceGrid& grid, LayerLoop loop = LayerLoop::unrolled);

  /// y = H z
  Step product(const VertexVector& z, const VertexVector& y);
  /// y = H z with the exact Hessian of the energy, which may be indefinite (see ExactHessian).
  Step exactProduct(const VertexVector& z, const VertexVector& y);
  /// r = b - H z
  Step residual(const VertexVector& z, const VertexVector& b, const VertexVector& r);
  /// next = z + omega D^-1 r, D the 3 x 3 blocks on the diagonal of H, r = b - H z.
  Step smoothing(const VertexVector& z, const VertexVector& r, const VertexVector& next);
  /// z = omega D^-1 b
  Step firstSmoothing(const VertexVector& b, const VertexVector& z);

  /// Takes `positions` (as DeviceGrid::positions()) as the linearisation point, inverts D there.
  void recordLinearisation(CommandStream& stream, const Buffer& positions) const;
  void record(CommandStream& stream, const Step& step) const;

  /// What is recorded from now on adds `damping` times the Laplacian whose edges weigh 1 to H.
  void setDamping(double damping) { damping_ = damping; }

  /// omega of what is recorded from now on. The default is the largest that can amplify nothing: 2
  /// by DeviceGrid::mostVertices(). With struts and corners that is 3; the largest eigenvalue of
  /// D^-1 H is 2.0 to 2.1 at the usual weights, up to 2.7 where only corners count.
  void setSmoothingWeight(double omega) { smoothingWeight_ = omega; }

  /// The linearisation point, as DeviceGrid::positions().
  const Buffer& positions() const { return positions_; }

 private:
  HessianPush push() const;
  Step columnStep(KernelFamily& kernels, const VertexVector& z, const VertexVector& result,
                  std::vector<KernelResource> others);

  const Device& device_;
  GridShape shape_;
  ColumnWalk walk_;
  GridTexels texels_;
  Buffer positions_;
  TexelView positionsView_;
  VertexVector inverseDiagonal_;
  VertexVector inverseOffDiagonal_;
  double damping_ = 0;
  double smoothingWeight_;
  KernelFamily products_;
  KernelFamily exactProducts_;
  KernelFamily residuals_;
  KernelFamily smoothings_;
  KernelFamily firstSmoothings_;
  ComputeKernel blocks_;
};

}  // namespace morphgrid
