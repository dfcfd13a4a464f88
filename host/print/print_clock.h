#pragma once
#include <Eigen/Core>
#include <vector>

namespace morphgrid {

/// How long a printer takes for moves: trapezoids of speed, with junctions passed at the speed
/// whose change the classic jerk rule allows, looking backward and forward over the queue.
class PrintClock {
 public:
  /// jerk: mm/s.
  explicit PrintClock(double jerk) : jerk_(jerk) {}

  /// move: mm; speed: mm/s; acceleration: mm/s^2.
  void add(const Eigen::Vector3d& move, double speed, double acceleration);
  /// Seconds for the moves since the last call, which begin and end at rest.
  double take();

 private:
  struct Move {
    Eigen::Vector3d direction;
    double length;
    double speed;
    double acceleration;
  };
  double junctionSpeed(const Move& before, const Move& after) const;

  double jerk_;
  std::vector<Move> moves_;
};

}  // namespace morphgrid
