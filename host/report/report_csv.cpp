#include "report/report_csv.h"

#include <fmt/format.h>

namespace morphgrid {
namespace {

void appendSamples(std::string& csv, const char* stage, const std::optional<Equilibrium>& run) {
  if (run) {
    for (const ConvergenceSample& s : run->history) {
      csv += fmt::format("{},{},{},{},{},{}\n", stage, s.iteration, s.energy, s.residual, s.seconds,
                         s.gridShare);
    }
  }
}
}  // namespace

std::string toInverseCsv(const InverseDesign& inverse) {
  std::string csv =
      "kind,number,rms_percent,max_percent,largest_shrink_percent,largest_strain_percent,"
      "struts_at_bound,cycles,adjoint_products,seconds\n";
  for (const InverseStep& s : inverse.steps) {
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", toString(s.kind), s.number, s.rmsPercent,
                       s.maxPercent, s.largestShrinkPercent, s.largestStrainPercent,
                       s.strutsAtBound, s.cycles, s.adjointProducts, s.seconds);
  }
  return csv;
}

std::string toConvergenceCsv(const RunRecord& record) {
  std::string csv = "stage,iteration,energy,residual,seconds,grid_share\n";
  appendSamples(csv, "in_plane", record.inPlane);
  appendSamples(csv, "full", record.full);
  return csv;
}
}  // namespace morphgrid
