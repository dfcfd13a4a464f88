#pragma once
#include <string>
#include <vector>

#include "print/print_tools.h"
#include "print/print_verdict.h"

namespace morphgrid {

/// How a grid would be printed, as far as a run tells it.
struct PrintAssessment {
  std::string printer;  ///< Their names.
  std::string material;
  std::string printerDigest{};  ///< Of all that their files say; empty in older states.
  std::string materialDigest{};
  double scale = 0;        ///< mm of the finished object per scene unit.
  double enlargement = 1;  ///< See planPrint().
  std::vector<Obstacle> obstacles;
};

/// By whom and of what, and no more.
PrintAssessment assessmentBy(const PrintTools& tools);
/// What planPrint() makes of a grid; what it throws is among the obstacles.
PrintAssessment assessPrint(const StrutGrid& grid, const PrintTools& tools,
                            const DesignBounds& design);
/// tools: that the plan was made with.
PrintAssessment assessmentOf(const PrintPlan& plan, const PrintTools& tools,
                             const DesignBounds& design);

/// In what the tools are others than those of a run: "printer", "material", both or none.
std::vector<std::string> changedTools(const PrintAssessment& run, const PrintTools& tools);

}  // namespace morphgrid
