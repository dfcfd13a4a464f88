#pragma once
#include <memory>
#include <vector>

#include "solve/multigrid_solver.h"

namespace morphgrid {

/// Keeps the multigrid solvers of a run's stages, with what they have allocated, for the next run.
class SolverKeeper {
 public:
  /// One that holds this grid: that of the last run where shape and model have stayed, which
  /// nothing else may use by now. Throws as MultigridSolver() does.
  std::shared_ptr<MultigridSolver> solverFor(const Device& device, const StrutGrid& grid);

  bool has(const GridShape& shape, Mechanics mechanics) const;
  void clear() { solvers_.clear(); }

 private:
  std::vector<std::shared_ptr<MultigridSolver>> solvers_;  ///< Of different shapes or models.
};

}  // namespace morphgrid
