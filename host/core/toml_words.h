#pragma once
#include <toml++/toml.h>

#include <string>

namespace morphgrid {

/// The text on one line, control characters as \xNN, cut where it is long.
std::string printable(const std::string& text);

/// What a node holds, short enough for a message: `4`, `0.5`, `"a word"`, `an array of 3`, `a
/// table`.
std::string inWords(const toml::node& node);

}  // namespace morphgrid
