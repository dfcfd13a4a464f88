#include "core/toml_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/nearest_name.h"
#include "core/toml_words.h"

namespace morphgrid {
namespace {

std::string dotted(const std::string& section, std::string_view name) {
  return section.empty() ? std::string(name) : fmt::format("{}.{}", section, name);
}

}  // namespace

TomlReader::TomlReader(const std::filesystem::path& file, toml::table document)
    : file_(file.string()), document_(std::move(document)) {}

TomlSection TomlReader::root() { return {*this, "", &document_, false}; }

TomlSection TomlReader::section(const std::string& name) {
  const bool isFirst = std::find(sections_.begin(), sections_.end(), name) == sections_.end();
  if (isFirst) {
    sections_.push_back(name);
  }
  const toml::node* node = document_.get(name);
  const toml::table* table = node ? node->as_table() : nullptr;
  if (node && !table && isFirst) reportUnfit(name, *node, "a table");
  return {*this, name, table, node && !table};
}

TomlSection TomlReader::table(const std::string& name, const toml::node& node) {
  const toml::table* table = node.as_table();
  if (table) {
    innerTables_.emplace_back(name, table);
  } else {
    reportUnfit(name, node, "a table");
  }
  return {*this, name, table, !table};
}

Place TomlReader::place(const toml::source_region& source) const {
  return source.path ? placeOf(source) : Place{file_};
}

std::filesystem::path TomlReader::folderOf(const toml::node& node) const {
  const toml::source_region& source = node.source();
  const bool inFile = source.path && !isOverride(source);
  return std::filesystem::path(inFile ? *source.path : file_).parent_path();
}

std::optional<double> TomlReader::number(const std::string& name, const toml::node& node,
                                         const NumberRange& range) {
  std::optional<double> value;
  if (const auto* integer = node.as_integer()) value = static_cast<double>(integer->get());
  if (const auto* real = node.as_floating_point()) value = real->get();
  if (value && range.contains(*value)) return value;
  reportUnfit(name, node, describe(range));
  return std::nullopt;
}

const toml::array* TomlReader::array(const std::string& name, const toml::node& node,
                                     std::size_t length, const std::string& allowed) {
  const toml::array* array = node.as_array();
  if (array && array->size() == length) return array;
  reportUnfit(name, node, allowed);
  return nullptr;
}

std::optional<Eigen::Vector3d> TomlReader::vector(const std::string& name, const toml::node& node,
                                                  const NumberRange& range,
                                                  const std::string& allowed) {
  const toml::array* numbers = array(name, node, 3, allowed);
  if (!numbers) return std::nullopt;
  std::optional<Eigen::Vector3d> vector = Eigen::Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const auto value = number(fmt::format("{}[{}]", name, axis), *numbers->get(axis), range);
    if (value && vector) {
      (*vector)[axis] = *value;
    } else {
      vector.reset();
    }
  }
  return vector;
}

void TomlReader::reportUnknownKeys() {
  reportUnknownKeys(document_, "");
  for (const auto& [name, table] : innerTables_) reportUnknownKeys(*table, name);
}

TomlReader::KnownKey& TomlReader::know(const std::string& section, std::string_view name) {
  if (KnownKey* known = findKnown(section, name)) return *known;
  return keys_.emplace_back(KnownKey{section, std::string(name)});
}

TomlReader::KnownKey* TomlReader::findKnown(const std::string& section, std::string_view name) {
  const auto found = std::find_if(keys_.begin(), keys_.end(), [&](const KnownKey& key) {
    return key.section == section && key.name == name;
  });
  return found == keys_.end() ? nullptr : &*found;
}

std::vector<std::string> TomlReader::welcomeNames(const std::string& section) const {
  std::vector<std::string> names;
  for (const KnownKey& key : keys_) {
    if (key.section == section && !key.rejected) names.push_back(key.name);
  }
  if (section.empty()) names.insert(names.end(), sections_.begin(), sections_.end());
  return names;
}

void TomlReader::reportUnknownKeys(const toml::table& table, const std::string& section) {
  for (auto&& [key, node] : table) {
    const std::string name(key.str());
    const bool isSection = std::find(sections_.begin(), sections_.end(), name) != sections_.end();
    if (section.empty() && isSection) {
      if (node.is_table()) reportUnknownKeys(*node.as_table(), name);
    } else if (!findKnown(section, name)) {
      problems.add(place(key.source()),
                   fmt::format("unknown key {}; {}", printable(dotted(section, name)),
                               suggestion(section, name)));
    }
  }
}

std::string TomlReader::suggestion(const std::string& section, std::string_view name) const {
  const std::vector<std::string> names = welcomeNames(section);
  if (const auto nearest = nearestName(name, names)) {
    return fmt::format("did you mean {}?", dotted(section, *nearest));
  }
  for (const KnownKey& key : keys_) {
    if (key.name == name && !key.rejected)
      return fmt::format("did you mean {}?", dotted(key.section, name));
  }
  return fmt::format("known here: {}", fmt::join(names, ", "));
}

void TomlReader::reportUnfit(const std::string& name, const toml::node& node,
                             const std::string& allowed) {
  problems.add(place(node), fmt::format("{} must be {}, got {}", name, allowed, inWords(node)));
}

}  // namespace morphgrid
