#pragma once
#include <string>

#include "report/run_record.h"

namespace morphgrid {

/// report.json: the keys are documented in docs/report.md; what a run does not have is null.
std::string toJson(const RunRecord& record);

}  // namespace morphgrid
