#pragma once
#include <string>

#include "report/run_record.h"

namespace morphgrid {

/// A short table for the terminal, with the paper's figures beside ours where the scene has them.
std::string toTable(const RunRecord& record);

/// Its rows alone, without what the solvers did.
std::string toFigureTable(const RunRecord& record);

}  // namespace morphgrid
