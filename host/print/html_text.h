#pragma once
#include <string>

namespace morphgrid {

/// The text as a page shows it: what HTML would take for markup is escaped.
std::string htmlText(const std::string& text);

}  // namespace morphgrid
