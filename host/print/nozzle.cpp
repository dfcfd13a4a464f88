#include "print/nozzle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace morphgrid {
namespace {

using Eigen::Vector2d;

constexpr double kLiftSpeed = 30;          // mm/s
constexpr double kLiftAcceleration = 300;  // mm/s^2, as the next.
constexpr double kFilamentAcceleration = 1250;
/// Shorter moves, mm, are rounding.
constexpr double kNoMove = 1e-6;

}  // namespace

Nozzle::Nozzle(const Printer& printer)
    : printer_(printer),
      filamentArea_(std::numbers::pi / 4 * printer.filamentDiameter * printer.filamentDiameter),
      travelAcceleration_(printer.flavour == Flavour::klipper ? printer.acceleration
                                                              : printer.travelAcceleration),
      clock_(printer.jerk),
      laidLow_(Vector2d::Constant(std::numeric_limits<double>::infinity())),
      laidHigh_(-laidLow_) {}

void Nozzle::layTo(const Vector2d& to, double area, double speed, bool isFirst) {
  const Vector2d move = to - at_;
  const double length = move.norm();
  if (length < kNoMove) return;
  text_.lay(to, length * area / filamentArea_, isFirst ? speed : 0);
  clock_.add({move.x(), move.y(), 0}, speed, printer_.acceleration);
  volume_ += length * area;
  laidLow_ = laidLow_.cwiseMin(at_).cwiseMin(to);
  laidHigh_ = laidHigh_.cwiseMax(at_).cwiseMax(to);
  at_ = to;
}

void Nozzle::moveTo(const Vector2d& to) {
  const Vector2d move = to - at_;
  if (move.norm() < kNoMove) return;
  text_.travel(to, printer_.travelSpeed);
  clock_.add({move.x(), move.y(), 0}, printer_.travelSpeed, travelAcceleration_);
  travelled_ += move.norm();
  at_ = to;
}

void Nozzle::moveAround(const Vector2d& hub, double radius, const Vector2d& to) {
  constexpr double kStep = 0.5;  // rad
  const auto angleAt = [&](const Vector2d& point) {
    return std::atan2(point.y() - hub.y(), point.x() - hub.x());
  };
  const double begin = angleAt(at_);
  const double sweep = std::remainder(angleAt(to) - begin, 2 * std::numbers::pi);
  const int steps = std::max(1, static_cast<int>(std::lround(std::abs(sweep) / kStep)));
  for (int step = 0; step <= steps; ++step) {
    const double angle = begin + sweep * step / steps;
    moveTo(hub + radius * Vector2d(std::cos(angle), std::sin(angle)));
  }
  moveTo(to);
}

void Nozzle::climbTo(double z) {
  if (std::abs(z - z_) < kNoMove) return;
  text_.height(z, kLiftSpeed);
  clock_.add({0, 0, z - z_}, kLiftSpeed, kLiftAcceleration);
  z_ = z;
}

void Nozzle::feedFilament(double length) {
  text_.filament(length, printer_.retractionSpeed);
  // To the clock it is a move of its own: the others stop for it.
  clock_.add({0, 0, length}, printer_.retractionSpeed, kFilamentAcceleration);
}

void Nozzle::drawBack() {
  if (isDrawnBack_ || printer_.retraction == 0) return;
  feedFilament(-printer_.retraction);
  isDrawnBack_ = true;
  ++retractions_;
}

void Nozzle::push() {
  if (!isDrawnBack_) return;
  feedFilament(printer_.retraction);
  isDrawnBack_ = false;
}

}  // namespace morphgrid
