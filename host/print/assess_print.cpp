#include "print/assess_print.h"

#include <sstream>

#include "core/error.h"
#include "print/print_plan.h"

namespace morphgrid {
namespace {

/// A reason for which nothing is printed is followed by what would do.
Obstacle obstacleOf(const std::string& reason) {
  const std::size_t colon = reason.rfind(": ");
  return colon == std::string::npos ? Obstacle{reason, ""}
                                    : Obstacle{reason.substr(0, colon), reason.substr(colon + 2)};
}

double scaleOf(const StrutGrid& grid, const PrintTools& tools) {
  try {
    return tools.request.scale ? *tools.request.scale
                               : largestScale(tools, grid.positions.topRows<2>());
  } catch (const InputError&) {  // It is among the reasons.
    return 0;
  }
}

}  // namespace

PrintAssessment assessmentOf(const PrintPlan& plan) {
  PrintAssessment assessment{.printer = plan.printer.name,
                             .material = plan.material.name,
                             .scale = plan.scale,
                             .enlargement = plan.enlargement,
                             .obstacles = {}};
  if (auto obstacle = strutsOutOfRange(plan)) {
    assessment.obstacles.push_back(std::move(*obstacle));
  }
  return assessment;
}

PrintAssessment assessPrint(const StrutGrid& grid, const PrintTools& tools) {
  try {
    return assessmentOf(planPrint("", grid, tools.printer, tools.material, tools.request));
  } catch (const InputError& error) {
    PrintAssessment assessment{.printer = tools.printer.name,
                               .material = tools.material.name,
                               .scale = scaleOf(grid, tools),
                               .obstacles = {}};
    std::istringstream reasons(error.what());
    for (std::string reason; std::getline(reasons, reason);) {
      assessment.obstacles.push_back(obstacleOf(reason));
    }
    return assessment;
  }
}

}  // namespace morphgrid
