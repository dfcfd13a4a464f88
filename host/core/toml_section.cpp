#include <fmt/format.h>

#include <algorithm>

#include "core/read_file.h"
#include "core/toml_reader.h"

namespace morphgrid {

TomlSection::TomlSection(TomlReader& reader, std::string name, const toml::table* table,
                         bool malformed)
    : reader_(&reader), name_(std::move(name)), table_(table), malformed_(malformed) {}

std::optional<bool> TomlSection::boolean(std::string_view key) {
  const toml::node* node = find(key, "true or false");
  if (!node) return std::nullopt;
  if (const auto* value = node->as_boolean()) return value->get();
  reportUnfit(key, *node);
  return std::nullopt;
}

std::optional<std::string> TomlSection::text(std::string_view key) {
  const toml::node* node = find(key, "a string");
  if (!node) return std::nullopt;
  if (const auto* value = node->as_string()) return value->get();
  reportUnfit(key, *node);
  return std::nullopt;
}

std::optional<std::filesystem::path> TomlSection::path(std::string_view key) {
  const auto name = text(key);
  if (!name) return std::nullopt;
  return reader_->folderOf(*node(key)) / *name;
}

std::optional<std::filesystem::path> TomlSection::file(std::string_view key,
                                                       const std::string& what,
                                                       const std::string& hint) {
  auto name = path(key);
  const auto reason = name ? whyUnreadable(*name) : std::nullopt;
  if (!reason) return name;
  const bool isMissing = !std::filesystem::exists(*name);
  reader_->problems.add(place(key), fmt::format("{} must name a readable {}, got {}: {}{}",
                                                fullName(key), what, name->string(), *reason,
                                                isMissing && !hint.empty() ? " " + hint : ""));
  return std::nullopt;
}

std::optional<std::int64_t> TomlSection::integer(std::string_view key, const IntegerRange& range) {
  const toml::node* node = find(key, describe(range));
  if (!node) return std::nullopt;
  const auto* value = node->as_integer();
  if (value && range.contains(value->get())) return value->get();
  reportUnfit(key, *node);
  return std::nullopt;
}

std::optional<double> TomlSection::number(std::string_view key, const NumberRange& range) {
  const toml::node* node = find(key, describe(range));
  return node ? reader_->number(fullName(key), *node, range) : std::nullopt;
}

std::optional<std::array<double, 2>> TomlSection::numberPair(std::string_view key,
                                                             const NumberRange& range) {
  const toml::array* pair = array(key, 2, "[first, last], each " + describe(range));
  if (!pair) return std::nullopt;
  const auto first = reader_->number(fullName(key) + "[0]", *pair->get(0), range);
  const auto last = reader_->number(fullName(key) + "[1]", *pair->get(1), range);
  if (!first || !last) return std::nullopt;
  return std::array{*first, *last};
}

const toml::array* TomlSection::array(std::string_view key, std::size_t length,
                                      const std::string& allowed) {
  const toml::node* node = find(key, allowed);
  return node ? reader_->array(fullName(key), *node, length, allowed) : nullptr;
}

const toml::array* TomlSection::array(std::string_view key, const std::string& allowed) {
  const toml::node* node = find(key, allowed);
  if (!node || node->is_array()) return node ? node->as_array() : nullptr;
  reportUnfit(key, *node);
  return nullptr;
}

std::optional<Eigen::Vector3d> TomlSection::vector(std::string_view key, const NumberRange& range,
                                                   const std::string& allowed) {
  const toml::node* node = find(key, allowed);
  return node ? reader_->vector(fullName(key), *node, range, allowed) : std::nullopt;
}

TomlSection TomlSection::table(std::string_view key, const std::string& allowed) {
  const toml::node* node = find(key, allowed);
  if (node && node->is_table()) return reader_->table(fullName(key), *node);
  if (node) reportUnfit(key, *node);
  return {*reader_, fullName(key), nullptr, node != nullptr};
}

void TomlSection::require(std::string_view key) {
  if (malformed_ || node(key)) return;
  reader_->problems.add(place(key), fmt::format("{} is missing: it must be {}", fullName(key),
                                                reader_->know(name_, key).allowed));
}

void TomlSection::reject(std::string_view key, const std::string& reason) {
  reader_->know(name_, key).rejected = true;
  if (node(key)) {
    reader_->problems.add(place(key), fmt::format("{} {}", fullName(key), reason));
  }
}

const toml::node* TomlSection::node(std::string_view key) const {
  return table_ ? table_->get(key) : nullptr;
}

Place TomlSection::place(std::string_view key) const {
  if (const toml::node* value = node(key)) return reader_->place(*value);
  Place start{reader_->file_, 1, 1};
  if (!table_) return start;
  const Place table = reader_->place(*table_);
  return table.line == 0 ? start : table;
}

std::string TomlSection::fullName(std::string_view key) const {
  return name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
}

const toml::node* TomlSection::find(std::string_view key, std::string allowed) {
  TomlReader::KnownKey& known = reader_->know(name_, key);
  known.allowed = std::move(allowed);
  return known.rejected ? nullptr : node(key);
}

void TomlSection::reportUnfit(std::string_view key, const toml::node& node) {
  reader_->reportUnfit(fullName(key), node, reader_->know(name_, key).allowed);
}

std::optional<std::size_t> TomlSection::word(std::string_view key,
                                             const std::vector<std::string>& words) {
  const toml::node* node = find(key, fmt::format("\"{}\"", fmt::join(words, "\" or \"")));
  if (!node) return std::nullopt;
  const auto* value = node->as_string();
  const auto found = std::find(words.begin(), words.end(), value ? value->get() : "");
  if (found != words.end()) return found - words.begin();
  reportUnfit(key, *node);
  return std::nullopt;
}

}  // namespace morphgrid
