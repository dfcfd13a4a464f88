#pragma once
#include <Eigen/Core>
#include <deque>
#include <utility>

namespace morphgrid {

/// Directions of L-BFGS for minimising over a box: variables that their gradient pushes against
/// their bound stay there, the others move.
class BoundedLbfgs {
 public:
  struct Pair {
    Eigen::VectorXd step;    ///< s, of the variables.
    Eigen::VectorXd change;  ///< y, how the gradient changed in that step.
  };

  /// low <= high, of the same size.
  BoundedLbfgs(Eigen::VectorXd low, Eigen::VectorXd high);

  /// The nearest point of the box.
  Eigen::VectorXd project(const Eigen::VectorXd& x) const {
    return x.cwiseMax(low_).cwiseMin(high_);
  }

  /// Downhill from x in the box; without pairs along -gradient, its largest entry `firstStep`.
  Eigen::VectorXd direction(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
                            double firstStep) const;

  /// Adds a pair: a step s, in which the gradient changed by y. Pairs without positive curvature
  /// are left out, and the oldest where there are too many.
  void add(const Eigen::VectorXd& s, const Eigen::VectorXd& y);
  void clear() { pairs_.clear(); }
  bool empty() const { return pairs_.empty(); }

  /// The pairs, the oldest first. Another BoundedLbfgs that is given them goes on as this one
  /// would.
  const std::deque<Pair>& pairs() const { return pairs_; }
  void setPairs(std::deque<Pair> pairs) { pairs_ = std::move(pairs); }

 private:
  /// 1 where a variable may move, 0 where the gradient holds it at its bound.
  Eigen::ArrayXd freedom(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient) const;

  Eigen::VectorXd low_;
  Eigen::VectorXd high_;
  std::deque<Pair> pairs_;
};

}  // namespace morphgrid
