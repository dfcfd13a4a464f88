#pragma once
#include <filesystem>
#include <string>

#include "report/run_record.h"

namespace morphgrid {

/// report.json: the keys are documented in docs/report.md; what a run does not have is null.
std::string toJson(const RunRecord& record);

/// convergence.csv: stage, iteration, energy, residual, seconds, share of the grid.
std::string toConvergenceCsv(const RunRecord& record);

/// optimise.csv: a row per step of inverse design.
std::string toInverseCsv(const InverseDesign& inverse);

/// A short table for the terminal, with the paper's figures beside ours where the scene has them.
std::string toTable(const RunRecord& record);

/// Its rows alone, without what the solvers did.
std::string toFigureTable(const RunRecord& record);

}  // namespace morphgrid
