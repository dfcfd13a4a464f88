#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>

#include "grid/strut_grid.h"

namespace morphgrid {

/// What acts on a joint of a frame from outside (docs/method.md, Weight and supports): a force f
/// that keeps its direction, and where the joint is held, springs to where and as it was printed,
/// `-f . u + sum of holding u^2 / 2 + 2 turning |v|^2`. u: its displacement since it was printed;
/// v: the vector of its rotation's quaternion, the sine of half the angle.
struct JointTerm {
  // Of a held joint's springs over what a lateral bar of the grid's spacing has: that much less
  // does it give way. More would only leave less of the digits of positions and rotations.
  static constexpr double kHolding = 100;
  static constexpr double kTurning = 1000;

  struct Value {
    double energy;
    Eigen::Vector3d force, moment;  ///< The gradient by displacements and by turns in space.
  };

  Eigen::Vector3d printed;
  Eigen::Vector3d load = Eigen::Vector3d::Zero();
  Eigen::Vector3d holding = Eigen::Vector3d::Zero();  ///< Along x, y, z; 0: free
  double turning = 0;

  /// Of a joint that is held, in a grid which has loads.
  static Eigen::Vector3d holdingOf(const StrutGrid& grid) {
    const double height = kHolding * grid.bars->lateral.stretching / grid.spacing;
    const double aside = grid.bars->loads->slide ? 0 : height;
    return {aside, aside, height};
  }
  static double turningOf(const StrutGrid& grid) {
    const BarSection& bar = grid.bars->lateral;
    return grid.bars->loads->slide ? 0
                                   : kTurning * std::max(bar.bendingN, bar.bendingB) / grid.spacing;
  }

  /// visit(term, joint) for all of a grid which has bars: first the loads, then what holds joints.
  template <typename Visit>
  static void forEach(const StrutGrid& grid, Visit visit) {
    const Bars& bars = *grid.bars;
    if (!bars.loads) {
      return;
    }
    for (int joint = 0; joint < grid.shape.vertexCount(); ++joint) {
      visit(JointTerm{.printed = bars.printed.col(joint), .load = bars.loads->forces.col(joint)},
            joint);
    }
    for (const int joint : bars.loads->held) {
      visit(JointTerm{.printed = bars.printed.col(joint),
                      .holding = holdingOf(grid),
                      .turning = turningOf(grid)},
            joint);
    }
  }

  Value evaluate(const Eigen::Vector3d& position, const Eigen::Quaterniond& rotation) const {
    const Eigen::Vector3d moved = position - printed;
    const Eigen::Vector3d force = holding.cwiseProduct(moved);
    return {force.dot(moved) / 2 + 2 * turning * rotation.vec().squaredNorm() - load.dot(moved),
            force - load, 2 * turning * rotation.w() * rotation.vec()};
  }

  /// How the moment changes with the joint's turn, exactly: symmetric where there is none.
  Eigen::Matrix3d momentByTurn(const Eigen::Quaterniond& rotation) const {
    const Eigen::Vector3d v = rotation.vec();
    const double w = rotation.w();
    Eigen::Matrix3d crossed;  // [v]x
    crossed << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return turning * (w * w * Eigen::Matrix3d::Identity() - v * v.transpose() - w * crossed);
  }
};

}  // namespace morphgrid
