#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morphgrid {

/// Insertions, deletions, replacements and swaps of neighbours that turn one word into the other.
int editDistance(std::string_view from, std::string_view to);

/// The name that a mistyped word most likely stands for: about one edit per three letters away, at
/// most.
std::optional<std::string> nearestName(std::string_view word,
                                       const std::vector<std::string>& names);

}  // namespace morphgrid
