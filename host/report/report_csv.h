#pragma once
#include <string>

#include "report/run_record.h"

namespace morphgrid {

/// convergence.csv: stage, iteration, energy, residual, seconds, share of the grid.
std::string toConvergenceCsv(const RunRecord& record);

/// optimise.csv: a row per step of inverse design.
std::string toInverseCsv(const InverseDesign& inverse);

}  // namespace morphgrid
