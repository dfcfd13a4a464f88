#pragma once
#include <string>
#include <vector>

#include "core/named_arrays.h"
#include "solve/equilibrium.h"

namespace morphgrid {

/// Adds an array F64 [N, 5]: iteration, energy, residual, seconds and grid share of each sample.
void addHistory(ArrayList& arrays, const std::string& name,
                const std::vector<ConvergenceSample>& history);

/// What addHistory() added. Throws InputError when the file has no such array, or it makes no
/// sense.
std::vector<ConvergenceSample> readHistory(const ArrayReader& reader, const std::string& name);

}  // namespace morphgrid
