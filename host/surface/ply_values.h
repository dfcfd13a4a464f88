#pragma once
#include "surface/ply_header.h"

namespace morphgrid {

/// Reads the values behind a PLY file's header, one after the other, ASCII or binary.
class PlyValues {
 public:
  /// `text` stands behind the header.
  PlyValues(const MeshSource& source, PlyFormat format, TextReader text);

  /// As a double: it holds every PLY type, and NaN. Throws InputError at the end of the file, and
  /// when an ASCII value is no number.
  double next(PlyType type);
  /// Passes over a value, whatever it says. Throws InputError at the end of the file.
  void skip(PlyType type);

  /// Bytes that are left, of a line too.
  std::size_t bytesLeft() const;
  /// The fewest bytes that a value takes.
  std::size_t leastBytes(PlyType type) const { return isAscii() ? 1 : byteCount(type); }

  /// Throws InputError unless nothing but white space is left.
  void requireEnd();

  /// With the line, or the byte behind the latest value.
  InputError error(std::string_view what) const;

 private:
  bool isAscii() const { return format_ == PlyFormat::ascii; }
  std::string_view nextWord();
  void requireBytes(std::size_t count) const;
  template <typename Value>
  double nextBinary();

  const MeshSource& source_;
  PlyFormat format_;
  TextReader text_;
  std::size_t offset_;  ///< Offset of the next value of a binary file.
};

}  // namespace morphgrid
