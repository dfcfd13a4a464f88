#pragma once
#include "core/toml_key.h"

namespace morphgrid {

/// Which kinds of records there are.
template <typename Record>
struct RecordKinds {
  std::vector<std::string> words;                 ///< Empty: one kind, without a name.
  std::function<Record(std::size_t)> beginsWith;  ///< Before a file is read.
};

/// What the documentation of a key says, cell by cell.
struct KeyRow {
  std::string name, type, range, defaultValue, meaning;
};

/// As scene files and documents write them: `1e-9`, `"a word"`, `[0, 0]`.
std::string tomlText(double number);
std::string tomlText(const std::array<double, 2>& pair);
std::string tomlText(std::int64_t integer);
std::string tomlText(bool boolean);
std::string tomlText(const std::string& text);

/// "> 0 and <= 1", "any".
std::string rangeText(const NumberRange& range);
std::string rangeText(const IntegerRange& range);

/// `"a"`, `"b"`: in code.
std::string listOfWords(const std::vector<std::string>& words);

/// A Markdown table, its heads first.
std::string toMarkdown(const std::vector<KeyRow>& rows);

/// "Only for ..." or "Not for ...", whichever is shorter; empty where all kinds are named.
std::string kindsInWords(const std::vector<std::size_t>& kinds,
                         const std::vector<std::string>& words);

/// The row of a key.
template <typename Record>
class KeyDocument {
 public:
  explicit KeyDocument(const RecordKinds<Record>& kinds) : kinds_(kinds) {}

  std::string table(const std::vector<TomlKey<Record>>& keys) const {
    std::vector<KeyRow> rows;
    for (const TomlKey<Record>& key : keys) rows.push_back(row(key));
    return toMarkdown(rows);
  }

  /// As TOML; nothing where the file need not give it and nothing stands for it.
  std::optional<std::string> defaultOf(const TomlKey<Record>& key) const {
    Record record = kinds_.beginsWith(key.kinds.empty() ? 0 : key.kinds.front());
    if (key.otherwise) key.otherwise(record);
    return std::visit([&](const auto& value) { return held(value, record); }, key.value);
  }

 private:
  KeyRow row(const TomlKey<Record>& key) const {
    const std::string kinds = kindsInWords(key.kinds, kinds_.words);
    return {key.name,
            std::visit([](const auto& value) { return typeOf(value); }, key.value) +
                (key.unit.empty() ? "" : ", " + key.unit),
            std::visit([](const auto& value) { return rangeOf(value); }, key.value), defaultIn(key),
            key.meaning + (kinds.empty() ? "" : " " + kinds + ".")};
  }

  std::string defaultIn(const TomlKey<Record>& key) const {
    if (key.isRequired) return "required";
    if (!key.defaultInWords.empty()) return key.defaultInWords;
    const auto value = defaultOf(key);
    return value ? '`' + *value + '`' : "none";
  }

  template <typename Key>
  static std::optional<std::string> held(const Key& key, const Record& record) {
    const auto value = key.access.get(record);
    return value ? std::optional(tomlText(*value)) : std::nullopt;
  }
  static std::optional<std::string> held(const WordKey<Record>& key, const Record& record) {
    const auto index = key.access.get(record);
    return index ? std::optional(tomlText(key.words[*index])) : std::nullopt;
  }
  static std::optional<std::string> held(const FileKey<Record>&, const Record&) { return {}; }
  static std::optional<std::string> held(const CustomKey<Record>&, const Record&) { return {}; }

  static std::string typeOf(const NumberKey<Record>&) { return "number"; }
  static std::string typeOf(const NumberPairKey<Record>&) { return "2 numbers"; }
  static std::string typeOf(const IntegerKey<Record>&) { return "integer"; }
  static std::string typeOf(const BooleanKey<Record>&) { return "boolean"; }
  static std::string typeOf(const WordKey<Record>&) { return "string"; }
  static std::string typeOf(const TextKey<Record>&) { return "string"; }
  static std::string typeOf(const FileKey<Record>&) { return "string"; }
  static std::string typeOf(const CustomKey<Record>& key) { return key.type; }

  static std::string rangeOf(const NumberKey<Record>& key) { return rangeText(key.range); }
  static std::string rangeOf(const NumberPairKey<Record>& key) {
    return "each " + rangeText(key.range);
  }
  static std::string rangeOf(const IntegerKey<Record>& key) { return rangeText(key.range); }
  static std::string rangeOf(const BooleanKey<Record>&) { return ""; }
  static std::string rangeOf(const WordKey<Record>& key) { return listOfWords(key.words); }
  static std::string rangeOf(const TextKey<Record>&) { return "any"; }
  static std::string rangeOf(const FileKey<Record>&) { return "a readable file"; }
  static std::string rangeOf(const CustomKey<Record>& key) { return key.range; }

  const RecordKinds<Record>& kinds_;
};

}  // namespace morphgrid
