#pragma once
#include "gpu/command_stream.h"
#include "solve/column_walk.h"
#include "solve/frame_kernels.h"
#include "solve/kernel_family.h"
#include "solve/vertex_vector.h"

namespace morphgrid {

enum class Precision {
  single,
  precise,  ///< Differences of positions and sums are in double precision.
};

/// The energy of a grid and its gradient, on the device. Lengths in units of the spacing, energies
/// in stiffness x spacing^2.
class GridGradient {
 public:
  /// The gradient at one buffer of positions.
  class Evaluation {
   private:
    friend GridGradient;
    Evaluation(TexelView positions, ComputeKernel kernel)
        : positions_(std::move(positions)), kernel_(std::move(kernel)) {}
    TexelView positions_;
    ComputeKernel kernel_;
  };

  struct Sums {
    double energy;
    double squaredNorm;  ///< of the gradient
  };

  /// Keeps references. Throws DeviceError when `precise` is asked of a device without float64.
  GridGradient(const Device& device, const DeviceGrid& grid, Precision precision,
               LayerLoop loop = LayerLoop::unrolled);

  /// positions: as DeviceGrid::positions(). Both buffers must outlive the evaluation.
  Evaluation evaluation(const Buffer& positions, const VertexVector& gradient);

  /// Writes the gradient, and the sums for sums() to read once the stream has run.
  void record(CommandStream& stream, const Evaluation& evaluation) const;

  /// The sums of the last evaluation that has run.
  Sums sums() const;

 private:
  std::uint32_t groupCount() const;

  const Device& device_;
  ColumnWalk walk_;
  GridTexels texels_;
  std::optional<FrameColumns> frame_;  ///< Of grids that are frames.
  Buffer partials_;
  Buffer sums_;
  KernelFamily kernels_;
  ComputeKernel reduction_;
};

}  // namespace morphgrid
