#pragma once
#include "core/toml_key.h"

namespace morphgrid {

/// Puts into a record what a key holds. Problems go to the reader; the record then stays.
template <typename Record>
class TomlKeyReader {
 public:
  /// Keeps references.
  TomlKeyReader(TomlReader& reader, TomlSection& section, Record& record)
      : reader_(reader), section_(section), record_(record) {}

  /// Whether there was a value, and it will do.
  bool read(const TomlKey<Record>& key) {
    if (key.otherwise && !section_.node(key.name)) {
      key.otherwise(record_);
    }
    return std::visit([&](const auto& value) { return readValue(key.name, value); }, key.value);
  }

 private:
  template <typename Value>
  bool set(const KeyAccess<Record, Value>& access, const std::optional<Value>& value) {
    if (value) access.set(record_, *value);
    return value.has_value();
  }

  bool readValue(const std::string& name, const NumberKey<Record>& key) {
    return set(key.access, section_.number(name, key.range));
  }
  bool readValue(const std::string& name, const NumberPairKey<Record>& key) {
    return set(key.access, section_.numberPair(name, key.range));
  }
  bool readValue(const std::string& name, const IntegerKey<Record>& key) {
    return set(key.access, section_.integer(name, key.range));
  }
  bool readValue(const std::string& name, const BooleanKey<Record>& key) {
    return set(key.access, section_.boolean(name));
  }
  bool readValue(const std::string& name, const WordKey<Record>& key) {
    return set(key.access, section_.word(name, key.words));
  }
  bool readValue(const std::string& name, const TextKey<Record>& key) {
    return set(key.access, section_.text(name));
  }
  bool readValue(const std::string& name, const FileKey<Record>& key) {
    return set(key.access, section_.file(name, key.what, key.hint));
  }
  bool readValue(const std::string& name, const CustomKey<Record>& key) {
    key.read(reader_, record_);
    return section_.node(name) != nullptr;
  }

  TomlReader& reader_;
  TomlSection& section_;
  Record& record_;
};

/// Puts into a record what sections hold; what is wrong or missing goes to the reader.
template <typename Record>
void readSections(TomlReader& reader, const std::vector<TomlKeySection<Record>>& sections,
                  Record& record) {
  for (const TomlKeySection<Record>& keys : sections) {
    TomlSection section = keys.name.empty() ? reader.root() : reader.section(keys.name);
    TomlKeyReader<Record> values(reader, section, record);
    for (const TomlKey<Record>& key : keys.keys) {
      values.read(key);
      if (key.isRequired) section.require(key.name);
    }
  }
}

/// Reads a file whose keys all stand at the top level. Throws InputError with every problem,
/// unknown keys among them, as `file:line:column: ...`, one a line.
template <typename Record>
Record readTopLevel(TomlReader& reader, const std::vector<TomlKey<Record>>& keys) {
  Record record{};
  readSections(reader, {TomlKeySection<Record>{"", keys}}, record);
  reader.reportUnknownKeys();
  reader.problems.throwIfAny();
  return record;
}

}  // namespace morphgrid
