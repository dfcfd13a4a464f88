#include "print/strut_lay.h"

#include <algorithm>

namespace morphgrid {
namespace {

/// The larger of nothing and the least, whichever is closer, below it.
double roundedUpTo(double least, double share) {
  return share < least / 2 ? 0 : std::max(share, least);
}

}  // namespace

StrutLay strutLayOf(const PrintMaterial& material, double hubDiameter) {
  return {-material.along.change, -material.across.change, -material.hub.change, hubDiameter};
}

double layableShare(double share, double freeLength) {
  const double least = std::min(0.5, kShortestZone / freeLength);
  const double inside = std::clamp(share, 0.0, 1.0);
  return inside < 0.5 ? roundedUpTo(least, inside) : 1 - roundedUpTo(least, 1 - inside);
}

}  // namespace morphgrid
