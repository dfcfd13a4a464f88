#pragma once
#include <filesystem>

#include "print/print_record.h"

namespace morphgrid {

/// What else than G-code, maps, report and assembly page is written.
struct PrintFileChoices {
  bool isPlain = false;  ///< G-code without comments that name struts and hubs.
  bool stl = false;      ///< tier_1.stl ..., see tierSolid().
  bool threeMf = false;  ///< tiers.3mf, the same in one file.
};

/// Writes tier_1.gcode, tier_1.svg and so on, the bottom one first, print.json, assembly.html and
/// what is chosen into a folder that is there; what an earlier print had more is removed. All are
/// written, or none is changed: then it throws InputError, when a tier cannot be laid or the disk
/// refuses. Fills record.tiers; where slicers have files to read, a notice says what these are for.
void writePrintFiles(PrintRecord& record, const std::filesystem::path& folder,
                     const PrintFileChoices& choices);

}  // namespace morphgrid
