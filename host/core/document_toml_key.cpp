#include "core/document_toml_key.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace morphgrid {
namespace {

/// What follows the words of describe(), which messages use.
std::string withoutArticle(const std::string& described, const std::string& article) {
  return described.rfind(article, 0) == 0 ? described.substr(article.size()) : "any";
}

std::vector<std::string> inCode(const std::vector<std::string>& words) {
  std::vector<std::string> code;
  for (const std::string& word : words) code.push_back("`\"" + word + "\"`");
  return code;
}

}  // namespace

std::string tomlText(double number) {
  std::string text = fmt::format("{}", number);
  const auto exponent = text.find("e-0");
  return exponent == text.npos ? text : text.erase(exponent + 2, 1);
}

std::string tomlText(const std::array<double, 2>& pair) {
  return fmt::format("[{}, {}]", tomlText(pair[0]), tomlText(pair[1]));
}

std::string tomlText(std::int64_t integer) { return fmt::format("{}", integer); }

std::string tomlText(bool boolean) { return boolean ? "true" : "false"; }

std::string tomlText(const std::string& text) { return '"' + text + '"'; }

std::string rangeText(const NumberRange& range) {
  return withoutArticle(describe(range), "a number ");
}

std::string rangeText(const IntegerRange& range) {
  return withoutArticle(describe(range), "an integer ");
}

std::string listOfWords(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(inCode(words), ", "));
}

std::string toMarkdown(const std::vector<KeyRow>& rows) {
  std::string table =
      "| Key | Type | Range | Default | Meaning |\n| --- | --- | --- | --- | --- |\n";
  for (const KeyRow& row : rows) {
    table += fmt::format("| `{}` | {} | {} | {} | {} |\n", row.name, row.type, row.range,
                         row.defaultValue, row.meaning);
  }
  return table;
}

std::string kindsInWords(const std::vector<std::size_t>& kinds,
                         const std::vector<std::string>& words) {
  if (kinds.empty() || kinds.size() == words.size()) return "";
  const bool isFew = 2 * kinds.size() <= words.size();
  std::vector<std::string> named;
  for (std::size_t kind = 0; kind < words.size(); ++kind) {
    const bool isIn = std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
    if (isIn == isFew) named.push_back(words[kind]);
  }
  return fmt::format("{} for {}", isFew ? "Only" : "Not", fmt::join(inCode(named), " and "));
}

}  // namespace morphgrid
