#pragma once
#include <string_view>

#include "report/run_record.h"

namespace morphgrid {

/// The record that toJson() wrote. What report.json does not hold is left out: positions, histories
/// and motions of the stages, the published figures, of a mesh its extent and the box suggested.
/// Throws InputError when it is no such report.
RunRecord readReport(std::string_view json);

}  // namespace morphgrid
