#include "surface/text_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace morphgrid {

std::optional<double> parseNumber(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0;
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool whole = problem == std::errc() && end == word.data() + word.size();
  return whole ? std::optional(value) : std::nullopt;
}

TextReader::TextReader(const MeshSource& source) : source_(source) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  source.refuseUtf16();
  if (source.bytes.starts_with(kMark)) next_ = kMark.size();
}

bool TextReader::nextLine() {
  const std::string_view text = source_.bytes.substr(next_);
  if (text.empty()) {
    rest_ = {};
    return false;
  }
  const std::size_t length = std::min(text.find_first_of("\r\n"), text.size());
  rest_ = text.substr(0, length);
  next_ += std::min(length + (text.substr(length).starts_with("\r\n") ? 2 : 1), text.size());
  ++line_;
  return true;
}

std::string_view TextReader::word() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size()));
  const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t"));
  rest_.remove_prefix(word.size());
  return word;
}

std::string_view TextReader::wordOfAnyLine() {
  std::string_view next = word();
  while (next.empty() && nextLine()) next = word();
  return next;
}

double TextReader::number(std::string_view word, std::string_view name) const {
  if (const auto value = parseNumber(word); value && std::isfinite(*value)) return *value;
  throw error(fmt::format("{} must be a finite number, got {}", name,
                          word.empty() ? "nothing" : inQuotes(word)));
}

}  // namespace morphgrid
