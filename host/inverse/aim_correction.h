#pragma once
#include <Eigen/Core>

#include "inverse/anderson_mixing.h"

namespace morphgrid {

/// Aims beyond a target by as much as what is designed falls short of it: the displacement
/// adjustment of tool makers against spring-back (Gan and Wagoner 2004), with Anderson's mixing.
/// Lengths that come from an aim fit together, so that coming closer strains no bar.
class AimCorrection {
 public:
  /// targets: 3 x n; aim: that which led to where the grid is now, at first the targets.
  AimCorrection(const Eigen::Matrix3Xd& targets, Eigen::Matrix3Xd aim);

  /// The next aim to try. reached: where the last one that was taken led, 3 x n, anywhere in space.
  const Eigen::Matrix3Xd& next(const Eigen::Matrix3Xd& reached);
  /// It comes closer.
  void take();
  /// The last one that was taken.
  const Eigen::Matrix3Xd& aim() const { return aim_; }
  /// It does not: the next one goes half as far.
  void refuse();
  /// Not worth another try.
  bool isExhausted() const;

 private:
  Eigen::Matrix3Xd targets_;
  Eigen::Matrix3Xd aim_;
  Eigen::Matrix3Xd trial_;
  AndersonMixing mixing_;
  double share_ = 1;
};

}  // namespace morphgrid
