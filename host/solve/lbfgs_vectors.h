#pragma once
#include <array>
#include <vector>

#include "gpu/command_stream.h"
#include "solve/device_grid.h"
#include "solve/grid_gradient.h"
#include "solve/lbfgs.h"
#include "solve/vertex_vector.h"

namespace morphgrid {

/// The vectors of L-BFGS in the device's memory, and the kernels that work on them. There are two
/// states, each of positions and gradient: the current one and the one on trial. Lengths in units
/// of the spacing.
class LbfgsVectors {
 public:
  /// Keeps references. The states' positions are the grid's two buffers.
  LbfgsVectors(const Device& device, const DeviceGrid& grid, Precision precision);

  /// What the preconditioner takes and gives.
  const VertexVector& rightSide() const { return rightSide_; }
  const VertexVector& correction() const { return correction_; }
  const VertexVector& direction() const { return direction_; }
  const Buffer& currentPositions() const { return *states_[current_].positions; }
  /// Whether the current positions are those of DeviceGrid::positions().
  bool currentIsFirst() const { return current_ == 0; }

  void recordCurrentGradient(CommandStream& stream) const;
  /// rightSide = gradient + sum of weights_i y_i
  void recordRightSide(CommandStream& stream, const PairHistory::Weights& weights) const;
  /// direction = correction + sum of weights_i s_i
  void recordDirection(CommandStream& stream, const PairHistory::Weights& weights) const;
  /// The trial state: positions - length x direction, with its gradient; the pair of this step in
  /// `slot`; dot products with the trial's gradient.
  void recordTrial(CommandStream& stream, double length, int slot) const;
  void recordDots(CommandStream& stream) const;

  /// Results of what the stream has run last.
  double largestStep() const;
  Dots dots() const;
  GridGradient::Sums sums() const { return gradient_.sums(); }

  /// The trial state becomes the current one.
  void accept() { current_ = 1 - current_; }

 private:
  struct State {
    const Buffer* positions;
    TexelView positionTexels;
    VertexVector gradient;
    GridGradient::Evaluation evaluation;
  };
  /// Kernels that read the current state, for either of the two.
  struct StateKernels {
    ComputeKernel rightSide;
    ComputeKernel step;
    std::vector<ComputeKernel> pair;  ///< Indexed by slot.
    ComputeKernel dots;
  };

  State state(const Buffer& positions);
  StateKernels stateKernels(const State& current, const State& trial);
  std::vector<KernelResource> texelsOf(std::uint32_t binding,
                                       const std::vector<VertexVector>& vectors) const;
  void recordDotsWith(CommandStream& stream, const ComputeKernel& kernel) const;

  const Device& device_;
  std::uint32_t count_;
  std::uint32_t vertexCount_;
  float resolution_;
  GridGradient gradient_;
  VertexVector rightSide_;
  VertexVector correction_;
  VertexVector direction_;
  std::vector<VertexVector> steps_;    ///< s, by slot
  std::vector<VertexVector> changes_;  ///< y, by slot
  Buffer largest_;
  Buffer dots_;
  KernelFamily combining_;
  KernelFamily stepping_;
  KernelFamily pairing_;
  KernelFamily dotting_;
  std::array<State, 2> states_;
  std::array<StateKernels, 2> kernels_;
  ComputeKernel combineDirection_;
  int current_ = 0;
};

}  // namespace morphgrid
