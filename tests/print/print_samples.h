#pragma once
#include "print/print_plan.h"

namespace morphgrid {

/// As printers/prusa_mk4.toml has it.
Printer samplePrinter();
/// As materials/pla_0.08.toml has it.
PrintMaterial sampleMaterial();

/// A grid of square cells of side 1, tiers 0.3 apart, all of whose lateral struts shrink by the
/// same share.
StrutGrid flatGrid(const GridShape& shape, double shrink);

/// Skewed cells of different sizes whose struts shrink by shares in [low, high].
StrutGrid randomGrid(const GridShape& shape, double low, double high, unsigned seed);

}  // namespace morphgrid
