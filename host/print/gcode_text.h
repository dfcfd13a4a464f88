#pragma once
#include <Eigen/Core>
#include <string>
#include <string_view>

namespace morphgrid {

/// G-code as it grows: numbers in fixed point, E relative, without drift.
class GcodeText {
 public:
  /// A whole line.
  void line(std::string_view text);
  /// A move; lengths in mm, the filament since the last such move; F is left out where speed, mm/s,
  /// is 0.
  void lay(const Eigen::Vector2d& to, double filament, double speed);
  void travel(const Eigen::Vector2d& to, double speed);
  void height(double z, double speed);
  void filament(double length, double speed);

  std::string take() { return std::move(text_); }
  std::size_t size() const { return text_.size(); }

 private:
  void word(char letter, double value, int decimals);
  void place(const Eigen::Vector2d& at);
  void feed(double speed);

  std::string text_;
  double laid_ = 0;         ///< Filament, exact.
  double writtenLaid_ = 0;  ///< As the rounded numbers add up.
};

/// Letters, digits and what else firmware takes in a comment or on its display; others become `_`,
/// and `;` a comma.
std::string plainText(std::string text);

}  // namespace morphgrid
