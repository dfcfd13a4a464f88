#pragma once
#include <memory>

#include "gpu/command_stream.h"
#include "solve/device_grid.h"
#include "solve/vertex_vector.h"

namespace morphgrid {

/// The Gauss-Newton Hessian H of a grid's energy at a linearisation point, matrix-free, and a
/// block-Jacobi smoother for it: the finest level of multigrid. Positive semidefinite. Lengths in
/// units of the spacing, energies in stiffness x spacing^2.
class Hessian {
 public:
  /// One of the operations below, bound to its vectors, to be recorded as often as wanted. They
  /// must outlive it.
  struct Step {
    enum class Dispatch { columns, vertices };
    ComputeKernel kernel;
    Dispatch dispatch;
  };

  virtual ~Hessian() = default;
  Hessian(const Hessian&) = delete;

  /// y = H z
  virtual Step product(const VertexVector& z, const VertexVector& y) = 0;
  /// y = H z with the exact Hessian of the energy, which may be indefinite (see ExactHessian).
  virtual Step exactProduct(const VertexVector& z, const VertexVector& y) = 0;
  /// r = b - H z
  virtual Step residual(const VertexVector& z, const VertexVector& b, const VertexVector& r) = 0;
  /// next = z + omega D^-1 r, D the blocks of a vertex on the diagonal of H, r = b - H z.
  virtual Step smoothing(const VertexVector& z, const VertexVector& r,
                         const VertexVector& next) = 0;
  /// z = omega D^-1 b
  virtual Step firstSmoothing(const VertexVector& b, const VertexVector& z) = 0;

  /// Takes `positions` (as DeviceGrid::positions()) as the linearisation point, inverts D there.
  virtual void recordLinearisation(CommandStream& stream, const Buffer& positions) const = 0;
  virtual void record(CommandStream& stream, const Step& step) const = 0;

  /// What is recorded from now on adds `damping` times the Laplacian whose edges weigh 1 to H.
  void setDamping(double damping) { damping_ = damping; }
  /// omega of what is recorded from now on.
  void setSmoothingWeight(double omega) { smoothingWeight_ = omega; }

  /// The linearisation point, as DeviceGrid::positions().
  const Buffer& positions() const { return positions_; }

 protected:
  Hessian(const Device& device, const DeviceGrid& grid, double smoothingWeight);

  float damping() const { return static_cast<float>(damping_); }
  float smoothingWeight() const { return static_cast<float>(smoothingWeight_); }
  const TexelView& positionsView() const { return positionsView_; }

 private:
  Buffer positions_;
  TexelView positionsView_;
  double damping_ = 0;
  double smoothingWeight_;
};

/// That of the grid's kind.
std::unique_ptr<Hessian> makeHessian(const Device& device, const DeviceGrid& grid);

}  // namespace morphgrid
