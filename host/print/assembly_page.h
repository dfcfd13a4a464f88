#pragma once
#include <string>

#include "print/print_record.h"

namespace morphgrid {

/// A tier seen from above, an SVG document at 1:1: struts by the share that is laid along them, the
/// more red, the more they shrink; those out of range dashed; the corner 0, 0 and a line of 50 mm.
std::string tierMap(const PrintPlan& plan, int tier);

/// How maps colour a strut, by the share that is laid along it: from blue, none, to red, all.
std::string shareColour(double share);

/// assembly.html: what to print, how to put it together, and the map of each tier. One file, which
/// needs no other.
std::string assemblyPage(const PrintRecord& record);

}  // namespace morphgrid
