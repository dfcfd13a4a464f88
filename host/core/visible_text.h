#pragma once
#include <string>
#include <string_view>

namespace morphgrid {

/// A text with control characters written out, as `\x1b`: a terminal would obey them, and pictures
/// and documents have no sign for them. text: UTF-8; kept: those that stay as they are.
std::string visibleText(std::string_view text, std::string_view kept = "");

}  // namespace morphgrid
