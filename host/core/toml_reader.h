#pragma once
#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/number_range.h"
#include "core/problem_list.h"
#include "core/toml_document.h"

namespace morphgrid {

class TomlSection;

/// Reads a TOML document against the keys that it is asked for. Problems pile up in `problems`,
/// each with its place, while reading goes on.
class TomlReader {
 public:
  /// `file` as given to parseToml().
  TomlReader(const std::filesystem::path& file, toml::table document);
  TomlReader(const TomlReader&) = delete;
  TomlReader& operator=(const TomlReader&) = delete;

  const toml::table& document() const { return document_; }
  TomlSection root();
  TomlSection section(const std::string& name);
  /// A table inside an array; `name` is what messages call it.
  TomlSection table(const std::string& name, const toml::node& node);

  Place place(const toml::node& node) const { return place(node.source()); }

  /// These report a problem and return nothing when the node is something else. `name` is what the
  /// message calls the node.
  std::optional<double> number(const std::string& name, const toml::node& node,
                               const NumberRange& range);
  const toml::array* array(const std::string& name, const toml::node& node, std::size_t length,
                           const std::string& allowed);
  /// An array of three numbers.
  std::optional<Eigen::Vector3d> vector(const std::string& name, const toml::node& node,
                                        const NumberRange& range, const std::string& allowed);

  /// To be called last: every key that nobody asked for is a problem.
  void reportUnknownKeys();

  ProblemList problems;

 private:
  friend class TomlSection;
  struct KnownKey {
    std::string section;
    std::string name;
    std::string allowed;  ///< Says what the value must be.
    bool rejected = false;
  };

  Place place(const toml::source_region& source) const;
  /// The folder of the file that the node stands in; for overrides, of the document's file.
  std::filesystem::path folderOf(const toml::node& node) const;
  KnownKey& know(const std::string& section, std::string_view name);
  KnownKey* findKnown(const std::string& section, std::string_view name);
  std::vector<std::string> welcomeNames(const std::string& section) const;
  void reportUnknownKeys(const toml::table& table, const std::string& section);
  std::string suggestion(const std::string& section, std::string_view name) const;
  void reportUnfit(const std::string& name, const toml::node& node, const std::string& allowed);

  std::string file_;
  toml::table document_;
  std::vector<std::string> sections_;
  std::vector<std::pair<std::string, const toml::table*>> innerTables_;
  std::vector<KnownKey> keys_;
};

/// One table of a document. Asking for a key makes it known; the answer is nothing when the key is
/// missing, rejected, or holds something else, which is then a problem. Lives as long as its
/// reader.
class TomlSection {
 public:
  bool present() const { return table_ != nullptr; }

  std::optional<bool> boolean(std::string_view key);
  std::optional<std::string> text(std::string_view key);
  /// A string that names a file relative to the one that it stands in; in an override, relative to
  /// the document's.
  std::optional<std::filesystem::path> path(std::string_view key);
  std::optional<std::int64_t> integer(std::string_view key, const IntegerRange& range);
  std::optional<double> number(std::string_view key, const NumberRange& range);
  /// An array of two numbers.
  std::optional<std::array<double, 2>> numberPair(std::string_view key, const NumberRange& range);
  /// An array of `length` elements of any kind.
  const toml::array* array(std::string_view key, std::size_t length, const std::string& allowed);
  /// An array of any length.
  const toml::array* array(std::string_view key, const std::string& allowed);

  /// An array of three numbers.
  std::optional<Eigen::Vector3d> vector(std::string_view key, const NumberRange& range,
                                        const std::string& allowed);
  TomlSection table(std::string_view key, const std::string& allowed);

  /// Which of several words it is.
  std::optional<std::size_t> word(std::string_view key, const std::vector<std::string>& words);

  /// As path(), of a file that can be read. what: what it is, e.g. "file"; hint: what to do where
  /// there is none; may be empty.
  std::optional<std::filesystem::path> file(std::string_view key, const std::string& what,
                                            const std::string& hint = "");

  /// A key asked for before that must be there.
  void require(std::string_view key);

  /// A known key that must not be there, and why; from here on it counts as missing.
  void reject(std::string_view key, const std::string& reason);

  /// Whatever the key holds, null when it is missing; the key does not become known.
  const toml::node* node(std::string_view key) const;

  /// Where the key's value stands, or the place at which it is missing.
  Place place(std::string_view key) const;

  /// The dotted name, e.g. "grid.layers".
  std::string fullName(std::string_view key) const;

 private:
  friend class TomlReader;
  TomlSection(TomlReader& reader, std::string name, const toml::table* table, bool malformed);

  const toml::node* find(std::string_view key, std::string allowed);
  void reportUnfit(std::string_view key, const toml::node& node);

  TomlReader* reader_;
  std::string name_;
  const toml::table* table_;  ///< Null when the document has no such table.
  bool malformed_;            ///< There is something of that name, but it is no table.
};

}  // namespace morphgrid
