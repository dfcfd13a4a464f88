#pragma once
#include "report/run_record.h"

namespace morphgrid {

/// A run with all that most runs have, of round figures.
RunRecord sampleRecord();

}  // namespace morphgrid
