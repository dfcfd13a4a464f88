#pragma once
#include <map>
#include <string>
#include <vector>

namespace morphgrid {

/// What stands for {bed} and its like in the G-code with which a print starts and ends.
using TemplateValues = std::map<std::string, std::string>;

/// The placeholders that printer files may use.
const std::vector<std::string>& templateNames();

/// Placeholders of the text that no value stands for, each once. A placeholder is a word of small
/// letters and `_` in braces; other braces mean themselves.
std::vector<std::string> unknownPlaceholders(const std::string& text,
                                             const std::vector<std::string>& known);

/// The command of each line, `G1`, in capitals; without comments and empty lines.
std::vector<std::string> commandsIn(const std::string& gcode);

/// The text with its placeholders replaced, without line breaks at its end; placeholders that are
/// not known stay.
std::string fillTemplate(const std::string& text, const TemplateValues& values);

}  // namespace morphgrid
