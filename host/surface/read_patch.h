#pragma once
#include <filesystem>

#include "surface/bezier_patch.h"

namespace morphgrid {

/// Reads a patch file: TOML with `control_points`, 4 rows (v) of 4 points (u) of 3 numbers.
/// Throws InputError with every problem as `file:line:column: ...`, one a line.
BezierPatch readPatch(const std::filesystem::path& file);

}  // namespace morphgrid
