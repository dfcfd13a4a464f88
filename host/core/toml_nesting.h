#pragma once
#include <optional>
#include <string_view>

namespace morphgrid {

/// Levels that arrays, inline tables, dotted keys and headers of a TOML text may have together:
/// the parser recurses once a level. No file of morphgrid's needs ten.
constexpr int kMostTomlLevels = 32;

/// A place in a text: line and column in bytes, from 1.
struct TextPosition {
  int line = 1;
  int column = 1;
};

/// Where a text, valid TOML or not, first has more levels than that; nothing where it never does.
/// Brackets and dots outside strings and comments count, a dot in a number as one in a key.
std::optional<TextPosition> findTooDeepNesting(std::string_view text);

}  // namespace morphgrid
