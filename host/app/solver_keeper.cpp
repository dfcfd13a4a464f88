#include "app/solver_keeper.h"

#include <algorithm>

namespace morphgrid {

std::shared_ptr<MultigridSolver> SolverKeeper::solverFor(const Device& device,
                                                         const StrutGrid& grid) {
  for (const auto& solver : solvers_) {
    if (solver->grid().shape == grid.shape &&
        solver->grid().bars.has_value() == grid.bars.has_value()) {
      solver->setGrid(grid);
      return solver;
    }
  }
  solvers_.push_back(std::make_shared<MultigridSolver>(device, grid));
  return solvers_.back();
}

bool SolverKeeper::has(const GridShape& shape) const {
  return std::any_of(solvers_.begin(), solvers_.end(),
                     [&](const auto& solver) { return solver->grid().shape == shape; });
}

}  // namespace morphgrid
