#include "print/gcode_text.h"

#include <charconv>
#include <cmath>

namespace morphgrid {
namespace {

constexpr double kPowers[] = {1, 10, 100, 1e3, 1e4, 1e5};

double roundedTo(double value, int decimals) {
  return std::round(value * kPowers[decimals]) / kPowers[decimals];
}

/// As "%.*f" would, several times as fast.
void appendFixed(std::string& text, double value, int decimals) {
  long long units = std::llround(value * kPowers[decimals]);
  if (units < 0) {
    text += '-';
    units = -units;
  }
  char digits[24];
  const auto result = std::to_chars(digits, digits + sizeof digits, units);
  const auto count = static_cast<int>(result.ptr - digits);
  if (count <= decimals) {
    text += decimals > 0 ? "0." : "0";
    text.append(decimals - count, '0');
    text.append(digits, count);
    return;
  }
  text.append(digits, count - decimals);
  if (decimals > 0) {
    text += '.';
    text.append(digits + count - decimals, decimals);
  }
}

}  // namespace

void GcodeText::word(char letter, double value, int decimals) {
  text_ += ' ';
  text_ += letter;
  appendFixed(text_, value, decimals);
}

void GcodeText::place(const Eigen::Vector2d& at) {
  word('X', at.x(), 3);
  word('Y', at.y(), 3);
}

void GcodeText::feed(double speed) {
  if (speed > 0) word('F', speed * 60, 0);
  text_ += '\n';
}

void GcodeText::line(std::string_view text) {
  text_ += text;
  text_ += '\n';
}

void GcodeText::lay(const Eigen::Vector2d& to, double filament, double speed) {
  laid_ += filament;
  const double step = roundedTo(laid_ - writtenLaid_, 5);
  writtenLaid_ += step;
  text_ += "G1";
  place(to);
  word('E', step, 5);
  feed(speed);
}

void GcodeText::travel(const Eigen::Vector2d& to, double speed) {
  text_ += "G0";
  place(to);
  feed(speed);
}

void GcodeText::height(double z, double speed) {
  text_ += "G1";
  word('Z', z, 3);
  feed(speed);
}

void GcodeText::filament(double length, double speed) {
  text_ += "G1";
  word('E', length, 5);
  feed(speed);
}

std::string plainText(std::string text) {
  for (char& letter : text) {
    const bool isPlain = letter >= ' ' && letter <= '~' && letter != '*';
    letter = !isPlain ? '_' : letter == ';' ? ',' : letter;
  }
  return text;
}

}  // namespace morphgrid
