#include "print/calibration_output.h"

#include <fmt/format.h>

#include "core/error.h"
#include "print/calibration_fit.h"

namespace morphgrid {
namespace {

bool isFittedMaterial(const std::filesystem::path& file) {
  try {
    return isFitted(readPrintMaterial(file));
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

void requireReplaceable(const std::filesystem::path& output,
                        const std::vector<CalibrationSource>& sources) {
  std::error_code none;  // Of a file that is not there.
  for (const CalibrationSource& source : sources) {
    if (std::filesystem::equivalent(output, source.file, none)) {
      throw InputError(
          fmt::format("{}: is {}, which would be lost: name another file to write, --out ANOTHER",
                      output.string(), source.what));
    }
  }
  const bool isFile = std::filesystem::exists(output, none) &&
                      !std::filesystem::is_directory(output, none);  // Those are never replaced.
  if (isFile && !isFittedMaterial(output)) {
    throw InputError(
        fmt::format("{}: is there and is no material that calibrate fit wrote: remove it, or name "
                    "another file to write, --out ANOTHER",
                    output.string()));
  }
}

}  // namespace morphgrid
