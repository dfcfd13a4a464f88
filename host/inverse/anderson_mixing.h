#pragma once
#include <Eigen/Core>
#include <deque>

namespace morphgrid {

/// Accelerates x <- x + r(x) towards r(x) = 0 (Anderson 1965; Walker and Ni 2011, type II): the
/// next x is where the residuals of the last few, combined linearly, are least.
class AndersonMixing {
 public:
  /// depth: differences that are kept, >= 0; none: the plain iteration.
  explicit AndersonMixing(std::size_t depth) : depth_(depth) {}

  /// The next x after `at`, where the residual is r.
  Eigen::VectorXd next(const Eigen::VectorXd& at, const Eigen::VectorXd& residual);

  void clear();

 private:
  struct Difference {
    Eigen::VectorXd at;
    Eigen::VectorXd residual;
  };

  std::size_t depth_;
  Eigen::VectorXd lastAt_;
  Eigen::VectorXd lastResidual_;
  std::deque<Difference> differences_;
};

}  // namespace morphgrid
