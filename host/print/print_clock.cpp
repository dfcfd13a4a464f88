#include "print/print_clock.h"

#include <algorithm>
#include <cmath>

namespace morphgrid {
namespace {

double reachable(double speed, double acceleration, double length) {
  return std::sqrt(speed * speed + 2 * acceleration * length);
}

/// Of a move that begins and ends at these speeds.
double trapezoidSeconds(double length, double speed, double acceleration, double begin,
                        double end) {
  const double squares = begin * begin + end * end;
  const double top = std::min(speed, std::sqrt((2 * acceleration * length + squares) / 2));
  const double ramps = (2 * top * top - squares) / (2 * acceleration);
  return (2 * top - begin - end) / acceleration + std::max(0.0, length - ramps) / top;
}

}  // namespace

void PrintClock::add(const Eigen::Vector3d& move, double speed, double acceleration) {
  const double length = move.norm();
  if (length > 0) {
    moves_.push_back({move / length, length, speed, acceleration});
  }
}

double PrintClock::junctionSpeed(const Move& before, const Move& after) const {
  const double slower = std::min(before.speed, after.speed);
  const double change = (after.direction - before.direction).cwiseAbs().maxCoeff() * slower;
  return change > jerk_ ? slower * jerk_ / change : slower;
}

double PrintClock::take() {
  const std::size_t count = moves_.size();
  if (count == 0) return 0;
  std::vector<double> speeds(count + 1, jerk_ / 2);  // Where moves begin and end.
  for (std::size_t n = 1; n < count; ++n) {
    speeds[n] = junctionSpeed(moves_[n - 1], moves_[n]);
  }
  speeds.front() = std::min(speeds.front(), moves_.front().speed);
  speeds.back() = std::min(speeds.back(), moves_.back().speed);
  for (std::size_t n = count; n-- > 0;) {
    const Move& move = moves_[n];
    speeds[n] = std::min(speeds[n], reachable(speeds[n + 1], move.acceleration, move.length));
  }
  double seconds = 0;
  for (std::size_t n = 0; n < count; ++n) {
    const Move& move = moves_[n];
    speeds[n + 1] = std::min(speeds[n + 1], reachable(speeds[n], move.acceleration, move.length));
    seconds +=
        trapezoidSeconds(move.length, move.speed, move.acceleration, speeds[n], speeds[n + 1]);
  }
  moves_.clear();
  return seconds;
}

}  // namespace morphgrid
