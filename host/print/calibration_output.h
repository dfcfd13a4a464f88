#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace morphgrid {

/// What a material is fitted from.
struct CalibrationSource {
  std::filesystem::path file;
  std::string what;  ///< "the table of measurements"
};

/// Throws InputError where a fitted material may not be written: over one of its sources, or over
/// anything but a material that `calibrate fit` wrote. output: need not be there.
void requireReplaceable(const std::filesystem::path& output,
                        const std::vector<CalibrationSource>& sources);

}  // namespace morphgrid
