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
    Eigen::VectorXd step;
    Eigen::VectorXd change;  ///< Of the gradient.
  };

  /// low <= high, of the same size.
  BoundedLbfgs(Eigen::VectorXd low, Eigen::VectorXd high);

  Eigen::VectorXd project(const Eigen::VectorXd& x) const {
    return x.cwiseMax(low_).cwiseMin(high_);
  }

  /// Downhill from x in the box; without pairs along -gradient, its largest entry `firstStep`.
  Eigen::VectorXd direction(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
                            double firstStep) const;

  /// After a step s by which the gradient changed by y. Pairs without positive curvature are left
  /// out.
  void add(const Eigen::VectorXd& s, const Eigen::VectorXd& y);
  void clear() { pairs_.clear(); }
  bool empty() const { return pairs_.empty(); }

  /// The oldest first. Given to another one, it goes on as this one would.
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
