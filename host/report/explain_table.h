#pragma once
#include <string>

namespace morphgrid {

/// What the rows of a table of toTable() mean, those that it has, a line each.
std::string explainTable(const std::string& table);

}  // namespace morphgrid
