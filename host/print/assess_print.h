#pragma once
#include "print/print_tools.h"
#include "print/print_verdict.h"

namespace morphgrid {

/// How a grid would be printed, as far as a run tells it.
struct PrintAssessment {
  std::string printer;  ///< Their names.
  std::string material;
  double scale = 0;        ///< mm of the finished object per scene unit.
  double enlargement = 1;  ///< See planPrint().
  std::vector<Obstacle> obstacles;
};

/// What planPrint() makes of a grid; what it throws is among the obstacles.
PrintAssessment assessPrint(const StrutGrid& grid, const PrintTools& tools);
PrintAssessment assessmentOf(const PrintPlan& plan);

}  // namespace morphgrid
