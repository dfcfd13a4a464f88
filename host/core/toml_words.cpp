#include "core/toml_words.h"

#include <fmt/format.h>

#include <algorithm>

namespace morphgrid {
namespace {

std::string realInWords(double value) {
  const std::string text = fmt::format("{}", value);
  const bool looksLikeInteger = text.find_first_not_of("-0123456789") == std::string::npos;
  return looksLikeInteger ? text + ".0" : text;
}

bool continuesCharacter(char byte) { return (static_cast<unsigned char>(byte) & 0xc0) == 0x80; }

}  // namespace

std::string printable(const std::string& text) {
  constexpr std::size_t kLongest = 60;
  std::size_t length = std::min(text.size(), kLongest);
  while (length < text.size() && continuesCharacter(text[length])) --length;
  std::string result;
  for (const char c : text.substr(0, length)) {
    const auto code = static_cast<unsigned char>(c);
    result += code < 0x20 || code == 0x7f ? fmt::format("\\x{:02x}", code) : std::string(1, c);
  }
  return result + (length < text.size() ? "..." : "");
}

std::string inWords(const toml::node& node) {
  if (const auto* value = node.as_integer()) return fmt::format("{}", value->get());
  if (const auto* value = node.as_floating_point()) return realInWords(value->get());
  if (const auto* value = node.as_boolean()) return value->get() ? "true" : "false";
  if (const auto* value = node.as_string()) return '"' + printable(value->get()) + '"';
  if (const auto* value = node.as_array()) return fmt::format("an array of {}", value->size());
  return node.is_table() ? "a table" : "a date or time";
}

}  // namespace morphgrid
