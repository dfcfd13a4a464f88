#include "app/solver_keeper.h"

#include <algorithm>

namespace morphgrid {
namespace {

bool isOf(const MultigridSolver& solver, const GridShape& shape, Mechanics mechanics) {
  return solver.grid().shape == shape && mechanicsOf(solver.grid()) == mechanics;
}

}  // namespace

std::shared_ptr<MultigridSolver> SolverKeeper::solverFor(const Device& device,
                                                         const StrutGrid& grid) {
  for (const auto& solver : solvers_) {
    if (isOf(*solver, grid.shape, mechanicsOf(grid))) {
      solver->setGrid(grid);
      return solver;
    }
  }
  solvers_.push_back(std::make_shared<MultigridSolver>(device, grid));
  return solvers_.back();
}

bool SolverKeeper::has(const GridShape& shape, Mechanics mechanics) const {
  return std::any_of(solvers_.begin(), solvers_.end(),
                     [&](const auto& solver) { return isOf(*solver, shape, mechanics); });
}

}  // namespace morphgrid
