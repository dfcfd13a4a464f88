#include "energy/strut_energy.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "energy/energy_terms.h"

namespace morphgrid {

using Eigen::Matrix3Xd;

StrutEnergy::StrutEnergy(const StrutGrid& grid)
    : grid_(grid), constraintWeights_(Eigen::VectorXd::Zero(grid.shape.vertexCount())) {
  forEachTerm(grid, [&](const auto& term, const auto& stencil) {
    mostVertices_ = std::max(mostVertices_, std::decay_t<decltype(term)>::kVertices);
    for (const Edge& edge : stencil) {
      constraintWeights_[edge.from] += term.projectionWeight();
      constraintWeights_[edge.to] += term.projectionWeight();
    }
  });
}

StrutEnergy::Value StrutEnergy::evaluate(const Matrix3Xd& positions) const {
  Value value{0, Matrix3Xd::Zero(3, positions.cols())};
  forEachTerm(grid_, [&](const auto& term, const auto& stencil) {
    const auto at = term.evaluate(differencesAlong(stencil, positions));
    value.energy += at.energy;
    addToEnds(stencil, at.gradient, value.gradient);
  });
  return value;
}

double StrutEnergy::residual(const Matrix3Xd& gradient) const {
  return gradient.norm() / (meanStiffness() * grid_.spacing * std::sqrt(double(gradient.cols())));
}

}  // namespace morphgrid
