#include "app/simulate_laid.h"

#include "inverse/check_from_flat.h"
#include "inverse/shape_error.h"

namespace morphgrid {

std::optional<LaidShape> simulateLaid(const Scene& scene,
                                      const std::optional<Eigen::Matrix3Xd>& targets,
                                      const Stage& designed, const StrutValues& rest,
                                      const Device& device) {
  const GridShape& shape = designed.grid.shape;
  const Equilibrium& end = designed.equilibrium;
  const Eigen::Matrix3Xd goal = targets ? *targets : middleLayer(shape, end.positions);
  StrutGrid grid = designed.grid;
  grid.rest = rest;
  MultigridSolver solver(device, grid);
  if (grid.bars) {
    solver.moveTo(end.positions, end.rotations);
  } else {
    solver.moveTo(end.positions);
  }
  SolveOptions options = scene.solve;
  options.startsNear = true;
  const Equilibrium laid = solver.solve(options);
  if (options.stopRequested()) return std::nullopt;
  const ShapeError asDesigned = computeShapeError(shape, end.positions, goal);
  const ShapeError asLaid = computeShapeError(shape, laid.positions, goal);
  LaidShape result{.model = nameOf(scene.material.model),
                   .hasTarget = targets.has_value(),
                   .designRmsPercent = asDesigned.rmsPercent,
                   .designMaxPercent = asDesigned.maxPercent,
                   .laidRmsPercent = asLaid.rmsPercent,
                   .laidMaxPercent = asLaid.maxPercent,
                   .isConverged = laid.converged};
  const auto fromFlat = checkFromFlat(solver, laid, goal, options, nullptr, {});
  if (!fromFlat) return std::nullopt;
  result.fromFlatRmsPercent = fromFlat->rmsPercent;
  result.endsThereFromFlat = fromFlat->sameEquilibrium;
  return result;
}

}  // namespace morphgrid
