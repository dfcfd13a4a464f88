#pragma once
#include <string>

namespace morphgrid {

/// How many decimals tell numbers apart that differ by `step`, > 0; 0 where the step is 1 or more.
int decimalsFor(double step);

/// The number that inDecimals() writes.
double roundedTo(double value, int decimals);

/// `value`, not 0, to so many digits in all.
double roundedToDigits(double value, int digits);

/// `value` to as many decimals, without zeros at the end: 5412343.52 rather than 5.41234e+06.
std::string inDecimals(double value, int decimals);

}  // namespace morphgrid
