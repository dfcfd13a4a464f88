#include "inverse/lateral_rest.h"

#include "energy/frame_energy.h"
#include "energy/strut_term.h"

namespace morphgrid {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

template <typename ValueOf>
VectorXd LateralRest::collect(const ValueOf& valueOf) const {
  VectorXd values(size());
  Eigen::Index n = 0;
  forEachLateralStrut(shape_, [&](const Strut& strut) { values[n++] = valueOf(strut); });
  return values;
}

VectorXd LateralRest::of(const StrutGrid& grid) const {
  return collect([&](const Strut& strut) { return valueAt(grid.rest, strut); });
}

StrutValues LateralRest::replacedIn(const StrutGrid& grid, const VectorXd& lengths) const {
  StrutValues rest = grid.rest;
  Eigen::Index n = 0;
  forEachLateralStrut(shape_, [&](const Strut& strut) { valueAt(rest, strut) = lengths[n++]; });
  return rest;
}

VectorXd LateralRest::lengthsAt(const Matrix3Xd& positions) const {
  return collect([&](const Strut& strut) { return lengthAt(positions, strut); });
}

VectorXd LateralRest::gradient(const StrutGrid& grid, const Equilibrium& equilibrium,
                               const Matrix3Xd& lambda) const {
  if (grid.bars) {
    const FramePlacement place{equilibrium.positions, equilibrium.rotations};
    return collect([&](const Strut& strut) {
      const BeamTerm term = BeamTerm::of(grid, strut);
      const Edge edge{strut.from, strut.to};
      return -term.gradientByRest(place.endsOf(term, edge)).dot(changeOfEnds(edge, lambda));
    });
  }
  return collect([&](const Strut& strut) {
    const auto stencil = StrutTerm::stencilOf(strut);
    const auto byRest =
        StrutTerm::of(grid, strut).gradientByRest(differencesAlong(stencil, equilibrium.positions));
    return -byRest.dot(differencesAlong(stencil, lambda));
  });
}

}  // namespace morphgrid
