#include "tests/support/height_field.h"

#include <fmt/format.h>

namespace morphgrid {

std::string heightFieldObj(const std::function<double(double, double)>& x,
                           const std::function<bool(double, double)>& cut) {
  constexpr int kCells = 20;
  std::string obj;
  const auto place = [](int n) { return 2.0 * n / kCells - 1; };
  for (int j = 0; j <= kCells; ++j) {
    for (int i = 0; i <= kCells; ++i) {
      obj += fmt::format("v {} {} {}\n", x(place(i), place(j)), place(i), place(j));
    }
  }
  for (int j = 0; j < kCells; ++j) {
    for (int i = 0; i < kCells; ++i) {
      if (cut && cut(place(i) + 1.0 / kCells, place(j) + 1.0 / kCells)) continue;
      const int first = j * (kCells + 1) + i + 1;
      obj +=
          fmt::format("f {} {} {} {}\n", first, first + 1, first + kCells + 2, first + kCells + 1);
    }
  }
  return obj;
}

}  // namespace morphgrid
