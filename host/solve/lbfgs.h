#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "shared/lbfgs_types.h"

namespace morphgrid {

/// Dot products of the vectors that L-BFGS keeps, by slot.
struct Dots {
  Eigen::Vector3d gradient;    ///< s_i . g
  Eigen::Vector3d correction;  ///< y_i . z
  Eigen::Matrix3d products;    ///< (i, j): s_i . y_j
  double descent;              ///< z . g
};

/// The scalars of L-BFGS's two-loop recursion, from dot products alone: the vectors stay on the
/// device, in kPairs slots of pairs (s, y).
class PairHistory {
 public:
  using Weights = std::array<float, kPairs>;

  /// Where the next pair is to be written: a free slot, or that of the oldest pair.
  int nextSlot() const;
  /// Takes the pair in nextSlot() for the newest, unless its curvature s . y is not positive.
  void add(const Eigen::Matrix3d& products);
  void clear() { slots_.clear(); }
  bool empty() const { return slots_.empty(); }

  /// First loop: q = g + sum of weights_i y_i.
  Weights firstLoop(const Dots& dots);
  /// Second loop, with z the preconditioned q: direction = z + sum of weights_i s_i.
  Weights secondLoop(const Dots& dots) const;

 private:
  std::vector<int> slots_;  ///< The oldest first.
  Eigen::Vector3d alpha_ = Eigen::Vector3d::Zero();
};

}  // namespace morphgrid
