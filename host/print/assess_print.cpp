#include "print/assess_print.h"

#include <sstream>

#include "core/digest.h"
#include "core/error.h"
#include "core/write_toml_keys.h"
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

PrintAssessment assessmentBy(const PrintTools& tools) {
  const std::string printer = TomlKeyWriter(tools.printer).write(printerKeys());
  return {.printer = tools.printer.name,
          .material = tools.material.name,
          .printerDigest = Digest().addList(printer).text(),
          .materialDigest = Digest().addList(printMaterialText(tools.material)).text(),
          .obstacles = {}};
}

PrintAssessment assessmentOf(const PrintPlan& plan, const PrintTools& tools,
                             const DesignBounds& design) {
  PrintAssessment assessment = assessmentBy(tools);
  assessment.scale = plan.scale;
  assessment.enlargement = plan.enlargement;
  if (auto obstacle = strutsOutOfRange(plan, design)) {
    assessment.obstacles.push_back(std::move(*obstacle));
  }
  return assessment;
}

std::vector<std::string> changedTools(const PrintAssessment& run, const PrintTools& tools) {
  const PrintAssessment now = assessmentBy(tools);
  const bool hasDigests = !run.printerDigest.empty();
  const bool isPrinter =
      hasDigests ? run.printerDigest == now.printerDigest : run.printer == now.printer;
  const bool isMaterial =
      hasDigests ? run.materialDigest == now.materialDigest : run.material == now.material;
  std::vector<std::string> changed;
  if (!isPrinter) changed.emplace_back("printer");
  if (!isMaterial) changed.emplace_back("material");
  return changed;
}

PrintAssessment assessPrint(const StrutGrid& grid, const PrintTools& tools,
                            const DesignBounds& design) {
  try {
    return assessmentOf(planPrint("", grid, tools.printer, tools.material, tools.request), tools,
                        design);
  } catch (const InputError& error) {
    PrintAssessment assessment = assessmentBy(tools);
    assessment.scale = scaleOf(grid, tools);
    std::istringstream reasons(error.what());
    for (std::string reason; std::getline(reasons, reason);) {
      assessment.obstacles.push_back(obstacleOf(reason));
    }
    return assessment;
  }
}

}  // namespace morphgrid
