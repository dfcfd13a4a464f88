#pragma once
#include <Eigen/Core>

#include "print/gcode_text.h"
#include "print/print_clock.h"
#include "print/print_path.h"
#include "print/printer.h"

namespace morphgrid {

/// Where the nozzle is, and what it does, as G-code. Lengths in mm, from the bed's corner.
class Nozzle {
 public:
  /// Keeps a reference to the printer.
  explicit Nozzle(const Printer& printer);

  /// Lays a line; area: of its cross-section, mm^2; speed: mm/s; isFirst: of several at one speed.
  void layTo(const Eigen::Vector2d& to, double area, double speed, bool isFirst);
  /// Moves, at the height where it is.
  void moveTo(const Eigen::Vector2d& to);
  /// Moves along a circle about a hub, as far as possible.
  void moveAround(const Eigen::Vector2d& hub, double radius, const Eigen::Vector2d& to);
  void climbTo(double z);
  /// Draws the filament back, unless it is, so that nothing drips on the way.
  void drawBack();
  void push();

  GcodeText& text() { return text_; }
  const Eigen::Vector2d& at() const { return at_; }
  double z() const { return z_; }
  bool isDrawnBack() const { return isDrawnBack_; }
  /// Seconds of the moves since the last call.
  double takeSeconds() { return clock_.take(); }

  double volume() const { return volume_; }  ///< Laid, mm^3.
  double filament() const { return volume_ / filamentArea_; }
  double travelled() const { return travelled_; }
  int retractions() const { return retractions_; }
  /// Where it has laid something; empty before.
  const Eigen::Vector2d& laidLow() const { return laidLow_; }
  const Eigen::Vector2d& laidHigh() const { return laidHigh_; }

 private:
  void feedFilament(double length);

  const Printer& printer_;
  double filamentArea_;  ///< mm^2
  double travelAcceleration_;
  GcodeText text_;
  PrintClock clock_;
  Eigen::Vector2d at_{0, 0};
  double z_ = 0;
  bool isDrawnBack_ = false;
  double volume_ = 0;
  double travelled_ = 0;
  int retractions_ = 0;
  Eigen::Vector2d laidLow_, laidHigh_;
};

}  // namespace morphgrid
