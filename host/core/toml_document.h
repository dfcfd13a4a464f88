#pragma once
#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <vector>

namespace morphgrid {

/// Parses a TOML file and then sets the overrides, `key=value` with dotted keys. A value that is no
/// TOML is taken as a string when it needs no quotes to be understood, e.g. "solver.method=jacobi".
/// A node's source().path is the file, or `--set key=value`.
/// Throws InputError when the file cannot be read, or when it or an override is malformed.
toml::table parseToml(const std::filesystem::path& file,
                      const std::vector<std::string>& overrides = {});

}  // namespace morphgrid
