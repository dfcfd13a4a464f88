#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/error.h"

namespace morphgrid {

/// A mesh file's name and bytes, and what turns a place in them into an error.
struct MeshSource {
  const std::filesystem::path& file;
  std::string_view bytes;

  InputError error(std::string_view what) const;                  ///< `file: what`
  InputError errorAtLine(int line, std::string_view what) const;  ///< `file:line: what`
  InputError errorAtByte(std::size_t offset,
                         std::string_view what) const;  ///< `file: byte n: what`

  /// Throws InputError when the file begins as UTF-16 does: with its mark, or letters of two bytes.
  void refuseUtf16() const;
};

/// Then every count of a file fits into an int: what is counted takes a byte at least.
inline constexpr std::size_t kMostMeshBytes = 0x7fffffff;

/// What a file of points without triangles is.
InputError pointCloudError(const MeshSource& source, std::size_t points);

/// The bytes of a regular file: a pipe would keep us waiting, and a device has no end. Throws
/// InputError when it cannot be read or is larger than kMostMeshBytes.
std::string readMeshFile(const std::filesystem::path& file);

/// Whether ASCII texts are the same but for capitals.
bool isSameWithoutCase(std::string_view a, std::string_view b);

/// "1 face", "2 faces": of words that take an s.
std::string countOf(std::size_t count, std::string_view noun);

/// A piece of a file as messages show it: one short line in quotes, whatever it holds.
std::string inQuotes(std::string_view text);

/// A library's message, or a piece of a file, as one line of at most 200 printable characters.
std::string oneLine(std::string_view text);

}  // namespace morphgrid
