#include "grid/bar_section.h"

#include <algorithm>
#include <cmath>

namespace morphgrid {

BarSection rectangularSection(const BarSize& size, double modulus) {
  const double area = size.width * size.height;
  const double shearModulus = modulus / (2 * (1 + size.poisson));
  const double longer = std::max(size.width, size.height);
  const double shorter = std::min(size.width, size.height);
  const double slenderness = shorter / longer;
  const double torsion = longer * std::pow(shorter, 3) *
                         (1.0 / 3 - 0.21 * slenderness * (1 - std::pow(slenderness, 4) / 12));
  return {.stretching = modulus * area,
          .bendingN = modulus * area * size.width * size.width / 12,
          .bendingB = modulus * area * size.height * size.height / 12,
          .twisting = shearModulus * torsion,
          .shearing = size.isShearing ? 6 / (5 * shearModulus * area) : 0,
          .joint = size.joint};
}

}  // namespace morphgrid
