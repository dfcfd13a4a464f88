#pragma once
#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/problem_list.h"

namespace morphgrid {

/// Parses a TOML file and then sets the overrides, `key=value` with dotted keys. A value that is no
/// TOML is taken as a string when it needs no quotes to be understood, e.g. "solver.method=jacobi".
/// A string `extends` at the top names another file, relative to this one, that gives the keys
/// which this one leaves out; that file may extend a third.
/// A node's source().path is its file, or `--set key=value`.
/// Throws InputError when a file cannot be read or extends itself, or when it or an override is
/// malformed.
toml::table parseToml(const std::filesystem::path& file,
                      const std::vector<std::string>& overrides = {});

/// The same of a text instead of a file, which errors name; it extends nothing. For what
/// parseToml() gave, printed.
toml::table parseTomlText(const std::string& text, const std::filesystem::path& file,
                          const std::vector<std::string>& overrides = {});

/// The same without what the file extends; a relative `extends` stays true beside the file.
toml::table parseTomlAlone(const std::filesystem::path& file,
                           const std::vector<std::string>& overrides = {});

/// The files that parseToml() reads: the file itself, then those that it extends.
std::vector<std::filesystem::path> listTomlFiles(const std::filesystem::path& file,
                                                 const std::vector<std::string>& overrides = {});

/// Whether a node of such a document was set by an override.
bool isOverride(const toml::source_region& source);

/// Where a node of such a document stands; overrides have no lines.
Place placeOf(const toml::source_region& source);

}  // namespace morphgrid
