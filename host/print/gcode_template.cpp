#include "print/gcode_template.h"

#include <algorithm>
#include <functional>
#include <sstream>

namespace morphgrid {
namespace {

bool isNameLetter(char letter) { return (letter >= 'a' && letter <= 'z') || letter == '_'; }

/// The text with each placeholder replaced by what `replace` makes of its name.
std::string replacePlaceholders(const std::string& text,
                                const std::function<std::string(const std::string&)>& replace) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at + 1;
    std::size_t end = begin;
    while (text[at] == '{' && end < text.size() && isNameLetter(text[end])) ++end;
    if (text[at] == '{' && end > begin && end < text.size() && text[end] == '}') {
      result += replace(text.substr(begin, end - begin));
      at = end + 1;
    } else {
      result += text[at++];
    }
  }
  return result;
}

}  // namespace

const std::vector<std::string>& templateNames() {
  static const std::vector<std::string> kNames{"bed", "nozzle", "bed_x", "bed_y", "z_end"};
  return kNames;
}

std::vector<std::string> unknownPlaceholders(const std::string& text,
                                             const std::vector<std::string>& known) {
  std::vector<std::string> unknown;
  replacePlaceholders(text, [&](const std::string& name) {
    const auto isIn = [&](const std::vector<std::string>& names) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    if (!isIn(known) && !isIn(unknown)) unknown.push_back(name);
    return std::string();
  });
  return unknown;
}

std::vector<std::string> commandsIn(const std::string& gcode) {
  std::vector<std::string> commands;
  std::istringstream lines(gcode);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find_first_of(";(")));
    std::string command;
    if (!(words >> command)) continue;
    for (char& letter : command) {
      if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
    }
    commands.push_back(command);
  }
  return commands;
}

std::string fillTemplate(const std::string& text, const TemplateValues& values) {
  std::string filled = replacePlaceholders(text, [&](const std::string& name) {
    const auto value = values.find(name);
    return value == values.end() ? '{' + name + '}' : value->second;
  });
  while (!filled.empty() && filled.back() == '\n') filled.pop_back();
  return filled;
}

}  // namespace morphgrid
