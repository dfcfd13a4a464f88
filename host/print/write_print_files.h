#pragma once
#include <filesystem>

#include "print/print_record.h"

namespace morphgrid {

/// Writes tier_1.gcode, tier_1.svg and so on, the bottom one first, print.json and assembly.html
/// into a folder that is there; files of tiers that an earlier print had more are removed. All are
/// written, or none is changed: then it throws InputError, when a tier cannot be laid or the disk
/// refuses. Fills record.tiers.
void writePrintFiles(PrintRecord& record, const std::filesystem::path& folder, bool isPlain);

}  // namespace morphgrid
