#include "energy/grid_energy.h"

#include <cmath>

#include "energy/beam_term.h"

namespace morphgrid {
namespace {

std::variant<StrutEnergy, FrameEnergy> energyOf(const StrutGrid& grid) {
  if (grid.bars) {
    return FrameEnergy(grid);
  }
  return StrutEnergy(grid);
}

double meanStiffnessOf(const StrutGrid& grid,
                       const std::variant<StrutEnergy, FrameEnergy>& energy) {
  if (const auto* springs = std::get_if<StrutEnergy>(&energy)) {
    return springs->meanStiffness();
  }
  double sum = 0;
  BeamTerm::forEach(grid, [&](const BeamTerm& term, const Edge&) {
    sum += 2 * term.section.stretching / (2 * term.rest);  // At both ends.
  });
  return 2 * sum / grid.shape.vertexCount();
}

}  // namespace

GridEnergy::GridEnergy(const StrutGrid& grid)
    : grid_(grid), energy_(energyOf(grid)), meanStiffness_(meanStiffnessOf(grid, energy_)) {}

GridEnergy::Value GridEnergy::evaluate(const Eigen::Matrix3Xd& positions,
                                       const JointRotations& rotations) const {
  if (const auto* springs = std::get_if<StrutEnergy>(&energy_)) {
    const StrutEnergy::Value value = springs->evaluate(positions);
    return {value.energy, springs->residual(value.gradient)};
  }
  const FrameEnergy::Value value = std::get<FrameEnergy>(energy_).evaluate(positions, rotations);
  const Eigen::Index count = positions.cols();
  const double forces = value.gradient.leftCols(count).norm() / grid_.spacing;
  const double moments = value.gradient.rightCols(count).norm() / (grid_.spacing * grid_.spacing);
  return {value.energy,
          std::hypot(forces, moments) / (meanStiffness_ * std::sqrt(static_cast<double>(count)))};
}

}  // namespace morphgrid
