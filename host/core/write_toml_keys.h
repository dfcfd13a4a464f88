#pragma once
#include "core/document_toml_key.h"

namespace morphgrid {

/// A text in quotes, with what TOML would take for something else escaped.
std::string quotedToml(std::string_view text);

/// The keys of a record with their values, as a TOML file that reads as the same record. Keys that
/// have none are left out.
template <typename Record>
class TomlKeyWriter {
 public:
  explicit TomlKeyWriter(const Record& record) : record_(record) {}

  std::string write(const std::vector<TomlKeySection<Record>>& sections) const {
    std::string text;
    for (const TomlKeySection<Record>& section : sections) {
      if (!section.name.empty()) text += "\n[" + section.name + "]\n";
      for (const TomlKey<Record>& key : section.keys) {
        const auto value = std::visit([&](const auto& kind) { return valueOf(kind); }, key.value);
        if (value) text += key.name + " = " + *value + '\n';
      }
    }
    return text;
  }

 private:
  template <typename Key>
  std::optional<std::string> valueOf(const Key& key) const {
    const auto value = key.access.get(record_);
    return value ? std::optional(tomlText(*value)) : std::nullopt;
  }
  std::optional<std::string> valueOf(const TextKey<Record>& key) const {
    const auto value = key.access.get(record_);
    return value ? std::optional(quotedToml(*value)) : std::nullopt;
  }
  std::optional<std::string> valueOf(const WordKey<Record>& key) const {
    const auto index = key.access.get(record_);
    return index ? std::optional(quotedToml(key.words[*index])) : std::nullopt;
  }
  std::optional<std::string> valueOf(const FileKey<Record>&) const { return {}; }
  std::optional<std::string> valueOf(const CustomKey<Record>&) const { return {}; }

  const Record& record_;
};

}  // namespace morphgrid
