#include "solve/energy_left.h"

#include <algorithm>
#include <cmath>

#include "energy/exact_hessian.h"
#include "energy/strut_energy.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;

// Of stiffness x spacing^2 a vertex.
constexpr double kNegligible = 1e-13;
constexpr int kMostProducts = 200;
// Steps in a row that add less than this share end the sum.
constexpr double kLittleMore = 0.01;
constexpr int kStepsOfLittle = 3;

// What is left of the energy falls with the square of the residual; a new bound goes by that, but
// by no more than this factor.
constexpr double kLeastTightening = 0.5;
constexpr double kMostTightening = 0.01;

double dotOf(const Matrix3Xd& a, const Matrix3Xd& b) { return a.cwiseProduct(b).sum(); }

}  // namespace

double negligibleEnergy(double meanStiffness, double vertexCount) {
  return kNegligible * meanStiffness * vertexCount;
}

double energyLeft(const StrutGrid& grid, const Matrix3Xd& positions,
                  const Preconditioner& preconditioner) {
  const Matrix3Xd gradient = StrutEnergy(grid).evaluate(positions).gradient;
  const double norm = gradient.norm();
  if (norm == 0) return 0;
  const ExactHessian hessian(grid, positions);
  // Preconditioners work in single precision: of norm 1 it is far from their least numbers.
  Matrix3Xd remainder = gradient / norm;
  Matrix3Xd direction = preconditioner(remainder);
  double slope = dotOf(remainder, direction);
  double left = 0;
  for (int n = 0, little = 0; n < kMostProducts && little < kStepsOfLittle; ++n) {
    const Matrix3Xd product = hessian.product(direction);
    const double curvature = dotOf(direction, product);
    if (!(curvature > 0 && slope > 0)) break;
    const double fall = slope * slope / (2 * curvature);
    left += fall;
    little = fall < kLittleMore * left ? little + 1 : 0;
    remainder -= slope / curvature * product;
    const Matrix3Xd next = preconditioner(remainder);
    const double nextSlope = dotOf(remainder, next);
    direction = next + nextSlope / slope * direction;
    slope = nextSlope;
  }
  return left * norm * norm;
}

double energyExcess(const StrutGrid& grid, const Matrix3Xd& positions, double energyTolerance,
                    const Preconditioner& preconditioner) {
  const StrutEnergy total(grid);
  const double energy = std::abs(total.evaluate(positions).energy);
  const double none = grid.spacing * grid.spacing *
                      negligibleEnergy(total.meanStiffness(), grid.shape.vertexCount());
  if (energyTolerance == 0 || energy <= none) return 0;
  return energyLeft(grid, positions, preconditioner) / (energyTolerance * energy);
}

double tightened(double residual, double energyExcess) {
  return residual * std::clamp(1 / std::sqrt(energyExcess), kMostTightening, kLeastTightening);
}

}  // namespace morphgrid
