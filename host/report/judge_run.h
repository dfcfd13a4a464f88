#pragma once
#include "print/print_record.h"
#include "report/run_record.h"

namespace morphgrid {

/// Whether what a run came to can be printed, and is of use: the one place that decides. laid: how
/// the grid that is laid morphs, where that was simulated; it then stands for the design's.
PrintVerdict judgeRun(const RunRecord& record, const LaidShape* laid = nullptr);

}  // namespace morphgrid
