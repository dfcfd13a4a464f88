#pragma once
#include "print/lay_struts.h"

namespace morphgrid {

/// Throws InputError with all that keeps a plan from being printed, one reason a line, with what
/// would do. Scale, enlargement, hub, heights and placing are set.
void requirePrintable(const PrintPlan& plan, const StrutGrid& grid);

/// The reasons for which the printer cannot lay the material at all; one a line.
void requireLayable(const Printer& printer, const PrintMaterial& material);

/// The scale below it that is a round number: 0.05 mm of 10.
double roundedDown(double scale);

}  // namespace morphgrid
