#pragma once
#include "solve/smallest_eigenvalue.h"

namespace morphgrid {

/// Energy, in stiffness x spacing^2, that positions of a grid cannot tell from none.
double negligibleEnergy(double meanStiffness, double vertexCount);

/// How far the energy would fall from `positions` to the equilibrium nearby, were it quadratic:
/// gradient . H^-1 gradient / 2 with the exact Hessian, within some percent, by conjugate
/// gradients in double precision on `preconditioner`. Of a grid of springs; in stiffness x the
/// square of the scene's unit of length. Near a saddle, what falls before H is negative.
double energyLeft(const StrutGrid& grid, const Eigen::Matrix3Xd& positions,
                  const Preconditioner& preconditioner);

/// How many times what energyTolerance allows, as a share of the energy, is left: at most 1 at an
/// end. 0 where energies do not count: with a tolerance of 0, and where there is none.
double energyExcess(const StrutGrid& grid, const Eigen::Matrix3Xd& positions,
                    double energyTolerance, const Preconditioner& preconditioner);

/// The bound of the residual to go on to from a residual at which so much was left.
double tightened(double residual, double energyExcess);

}  // namespace morphgrid
