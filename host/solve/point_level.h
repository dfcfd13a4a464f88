#pragma once
#include <array>

#include "shared/multigrid_types.h"
#include "solve/point_kernel.h"

namespace morphgrid {

/// A buffer that kernels write, with a view through which they read texels of four components.
class TexelBuffer {
 public:
  TexelBuffer(const Device& device, std::size_t texels, TexelFormat format, MemoryKind kind);

  const Buffer& buffer() const { return buffer_; }
  const TexelView& texels() const { return texels_; }

 private:
  Buffer buffer_;
  TexelView texels_;
};

/// A block of 6 x 6 for every point, as shaders/shared/multigrid_types.h lays it out.
class BlockField {
 public:
  BlockField(const Device& device, int pointCount, MemoryKind kind);

  /// Its texels, or its buffers, at the three bindings from `binding` on.
  void appendTexels(std::vector<KernelResource>& resources, std::uint32_t binding) const;
  void appendBuffers(std::vector<KernelResource>& resources, std::uint32_t binding) const;

  const TexelBuffer& part(std::size_t n) const { return parts_[n]; }

 private:
  std::vector<TexelBuffer> parts_;
};

/// The kernels of the coarse levels, each compiled once.
struct PointKernels {
  explicit PointKernels(const Device& device);

  KernelFamily inversion;
  KernelFamily firstSmoothing;
  KernelFamily residual;
  KernelFamily smoothing;
  KernelFamily levers;
  KernelFamily product;
  KernelFamily restriction;
  KernelFamily prolongation;
};

/// A coarse level: its matrix A, the rigid motions that it works on, and a block-Jacobi smoother. A
/// motion is a vec4 (t, 0) and a vec4 (w, 0) a point.
class PointLevel {
 public:
  /// memory: where centres and matrix lie; the host reads them where it is MemoryKind::host.
  /// spectralRadiusBound: of D^-1 A. Throws DeviceError when the device's limits are exceeded.
  PointLevel(const Device& device, PointKernels& kernels, PointGrid points, MemoryKind memory,
             double spectralRadiusBound);
  PointLevel(const PointLevel&) = delete;

  PointGrid points() const { return points_; }
  /// One of kStencilSelf ... kStencilNorthWest.
  const BlockField& blocks(std::size_t direction) const { return matrix_[direction]; }
  const BlockField& inverse() const { return inverse_; }
  /// ivec4 a point, fixed-point as DeviceGrid::positions().
  const TexelBuffer& centres() const { return centres_; }
  const TexelBuffer& rightSide() const { return rightSide_; }
  const TexelBuffer& iterate() const { return iterate_; }
  /// The residual, and after the last smoothing step the new iterate.
  const TexelBuffer& result() const { return result_; }

  std::vector<KernelResource> matrixTexels() const;
  std::vector<KernelResource> matrixBuffers() const;

  /// Inverts D, the blocks on the diagonal of A.
  void recordInversion(CommandStream& stream) const;
  /// iterate = omega D^-1 rightSide
  void recordFirstSmoothing(CommandStream& stream) const;
  /// result = rightSide - A iterate
  void recordResidual(CommandStream& stream) const;
  /// result = iterate + omega D^-1 (rightSide - A iterate)
  void recordSmoothing(CommandStream& stream) const;

  double smoothingWeight() const { return smoothingWeight_; }

 private:
  SmoothingPush push() const;
  PointKernel inversionKernel(PointKernels& kernels) const;
  PointKernel firstSmoothingKernel(PointKernels& kernels) const;
  PointKernel residualKernel(PointKernels& kernels) const;
  PointKernel smoothingKernel(PointKernels& kernels) const;

  const Device& device_;
  PointGrid points_;
  double smoothingWeight_;
  std::vector<BlockField> matrix_;
  BlockField inverse_;
  TexelBuffer centres_;
  TexelBuffer rightSide_;
  TexelBuffer iterate_;
  TexelBuffer result_;
  PointKernel inversion_;
  PointKernel firstSmoothing_;
  PointKernel residual_;
  PointKernel smoothing_;
};

}  // namespace morphgrid
