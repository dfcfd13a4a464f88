#pragma once
#include <toml++/toml.h>

#include <filesystem>

namespace morphgrid {

/// The files that prints are made with.
enum class PrintFileKind { printer, material };

/// Throws InputError where a file is one of another kind, which its keys tell: a line that says so
/// in place of one for each key.
void requireKind(PrintFileKind kind, const std::filesystem::path& file,
                 const toml::table& document);

}  // namespace morphgrid
