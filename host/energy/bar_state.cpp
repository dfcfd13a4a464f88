#include "energy/bar_state.h"

#include <algorithm>
#include <cmath>

#include "grid/bar_section.h"

namespace morphgrid {
namespace {

/// Curvature changes linearly from one end to the other, so that it is largest at an end.
double bendingStrainOf(const BeamTerm& term, const BeamTerm::Strains<double>& strains) {
  const BarSection& section = term.section;
  const BeamTerm::Strains<double> stiffness = term.stiffness();
  const Eigen::Array2d bending(section.bendingN, section.bendingB);
  const Eigen::Array2d mean = strains.segment<2>(1) / term.rest;
  const Eigen::Array2d change =
      stiffness.segment<2>(3).array() * strains.segment<2>(3).array() / bending;
  const Eigen::Array2d farthest = rectangleOf(section) / 2;
  return std::max((farthest * (mean + change).abs()).sum(),
                  (farthest * (mean - change).abs()).sum());
}

double jointRotationOf(const BeamTerm& term, const BeamTerm::Ends<double>& ends) {
  const Eigen::Vector3d chord = ends.arm - term.section.joint * (ends.a.col(0) + ends.b.col(0));
  const auto angleTo = [&](const Eigen::Vector3d& along) {
    return std::atan2(along.cross(chord).norm(), along.dot(chord));
  };
  return std::max(angleTo(ends.a.col(0)), angleTo(ends.b.col(0)));
}

}  // namespace

BarState barStateAt(const StrutGrid& grid, const FramePlacement& place, const Strut& strut) {
  const BeamTerm term = BeamTerm::of(grid, strut);
  const BeamTerm::Ends<double> ends = place.endsOf(term, {strut.from, strut.to});
  const BeamTerm::Strains<double> strains = term.strains(ends);
  const BeamTerm::Strains<double> energies = strains.cwiseAbs2().cwiseProduct(term.stiffness()) / 2;
  return {.axialEnergy = energies[0],
          .bendingEnergy = energies[1] + energies[2],
          .shearEnergy = energies[3] + energies[4],
          .twistEnergy = energies[5],
          .bendingStrain = bendingStrainOf(term, strains),
          .jointRotation = jointRotationOf(term, ends)};
}

}  // namespace morphgrid
