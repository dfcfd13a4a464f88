#pragma once
#include <optional>
#include <string>

#include "print/print_plan.h"

namespace morphgrid {

/// Why what is not joined would be laid in one place: hubs that overlap, struts that cross or run
/// into others' hubs; nothing where all keep clear. Struts that meet at a hub are
/// requirePrintable()'s.
std::optional<std::string> findOverlaps(const PrintPlan& plan);

}  // namespace morphgrid
