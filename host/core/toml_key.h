#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/number_range.h"
#include "core/toml_reader.h"

namespace morphgrid {

// The one place that says what a key of a TOML file is; readers, documents and knobs are made from
// it. Record: what the file is read into. Kinds: of records, where they differ in their keys.

/// How a key's value gets into a record and out of it.
template <typename Record, typename Value>
struct KeyAccess {
  std::function<std::optional<Value>(const Record&)> get;  ///< Nothing where none is set.
  std::function<void(Record&, const Value&)> set;
};

template <typename Record>
struct NumberKey {
  KeyAccess<Record, double> access;
  NumberRange range;
};

template <typename Record>
struct NumberPairKey {
  KeyAccess<Record, std::array<double, 2>> access;
  NumberRange range;
};

template <typename Record>
struct IntegerKey {
  KeyAccess<Record, std::int64_t> access;
  IntegerRange range;
};

template <typename Record>
struct BooleanKey {
  KeyAccess<Record, bool> access;
};

/// One of several words; the value is its index.
template <typename Record>
struct WordKey {
  KeyAccess<Record, std::size_t> access;
  std::vector<std::string> words;
};

template <typename Record>
struct TextKey {
  KeyAccess<Record, std::string> access;
};

/// A file that can be read.
template <typename Record>
struct FileKey {
  KeyAccess<Record, std::filesystem::path> access;
  std::string what = "file";  ///< For messages.
  std::string hint;           ///< What to do where there is none; may be empty.
  /// The files that such a file names in its turn. Empty: it names none.
  std::function<std::vector<std::filesystem::path>(const std::filesystem::path&)> listNamed = {};
};

/// What has a reader of its own.
template <typename Record>
struct CustomKey {
  std::function<void(TomlReader&, Record&)> read;
  std::string type;
  std::string range;
};

/// How people are offered to turn a value.
struct KnobOffer {
  std::string label;
  double low = 0;  ///< The knob's range, for numbers.
  double high = 0;
  bool isLogarithmic = false;
  bool isRelative = false;  ///< low and high are times the value that the record has.
};

template <typename Record>
struct TomlKey {
  std::string name;
  std::variant<NumberKey<Record>, NumberPairKey<Record>, IntegerKey<Record>, BooleanKey<Record>,
               WordKey<Record>, TextKey<Record>, FileKey<Record>, CustomKey<Record>>
      value;
  std::string unit;                ///< May be empty.
  std::vector<std::size_t> kinds;  ///< The kinds of records that have the key; empty: all.
  bool isRequired = false;         ///< Whether these kinds must have it.
  /// Called where the file leaves the key out; keys before it have been read. May be empty.
  std::function<void(Record&)> otherwise;
  std::string defaultInWords;  ///< Where it is not what a record begins with.
  std::optional<KnobOffer> knob;
  std::string meaning;

  bool isOf(std::size_t kind) const {
    return kinds.empty() || std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
  }
};

template <typename Record>
struct TomlKeySection {
  std::string name;  ///< Empty: the top level.
  std::vector<TomlKey<Record>> keys;
};

}  // namespace morphgrid
