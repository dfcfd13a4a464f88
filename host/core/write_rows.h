#pragma once
#include <cstddef>
#include <functional>
#include <ostream>
#include <string>

namespace morphgrid {

/// Writes rows 0, ..., count - 1 in their order. append(bytes, n) adds row n to the bytes: rows are
/// made on all cores, some megabytes at a time.
void writeRows(std::ostream& stream, std::ptrdiff_t count,
               const std::function<void(std::string& bytes, std::ptrdiff_t row)>& append);

}  // namespace morphgrid
